// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/store/mechanics_file.hpp"

#include "corruption.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/files/sealed_file.hpp"
#include "ionskin/history/shear_statistics.hpp"
#include "ionskin/results/hdf5/hdf5_file.hpp"
#include "ionskin/study/store/mechanics_store.hpp"
#include "scratch_folder.hpp"
#include "synthetic_contact.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace ionskin::study {
namespace {

/// Strains that are held.
class HeldStrains : public mechanics::StrainSource {
public:
  const mechanics::CoreStrain& at(std::size_t place) override { return strains.at(place); }
  mechanics::LayerStrainAt all_layers() const override {
    return [this](std::size_t place) { return mechanics::LayerStrain{strains.at(place), {}}; };
  }
  const std::vector<double>& largest_electrode_stress() const override { return stress; }
  double worst_equilibrium_residual() const override { return 1e-12; }

  std::vector<mechanics::CoreStrain> strains;
  std::vector<double> stress{3e6, 4e6};
};

/// On one cell, with its tractions.
mechanics::ContactSolution small_contact(const Case& input) {
  auto contact = handover::synthetic_contact(input);
  contact.cell_lines_x = {-1e-3, 1e-3};
  contact.cell_lines_y = {-1e-3, 0};
  const auto held = std::make_shared<HeldStrains>();
  for (const auto& instant : contact.stepped) {
    if (auto state = std::const_pointer_cast<mechanics::ContactState>(instant.state)) {
      state->normal_traction = {2e6};
      state->tangential_traction_x = state->tangential_traction_y = {1e5};
      state->slip = {1e-6};
      state->stick_reserve = {instant.time > 0.5 ? 0.0 : 1e5};
      state->surface = {1e-6, 0, 0};
      state->place = held->strains.size();
      state->source = held;
      held->strains.push_back(state->strain);
    }
  }
  return contact;
}

TEST(MechanicsFile, GivesBackWhatTheRestOfTheRunNeeds) {
  const results::ScratchFolder folder;
  const Case input = handover::small_case();
  auto contact = small_contact(input);
  contact.warnings = {"a warning"};
  auto record = make_mechanics_record(input, contact);
  const auto coarser =
      std::make_shared<const MechanicsRecord>(make_mechanics_record(input, contact));
  record.coarser_solutions["mesh"] = coarser;
  EXPECT_EQ(record.worst_equilibrium_residual, 1e-12);
  EXPECT_EQ(record.electrode_stress, (std::vector<double>{3e6, 4e6}));
  ASSERT_EQ(record.normal_force.size(), record.history.time.size());
  ASSERT_EQ(record.maps.maps.size(), 1u + 2 + 9 + 2);
  for (const results::ContactMap& map : record.maps.maps) {
    ASSERT_EQ(map.slip_state.size(), 1u) << map.state;
    EXPECT_EQ(map.slip_state[0], map.state == "touchdown" ? 1 : 3) << map.state;
    ASSERT_EQ(map.slip_since_landing.size(), 1u) << map.state;
  }

  const auto path = folder.path() / "results.h5";
  write_mechanics(path, "hash", record);
  const auto read = read_mechanics(path, "hash", input.skin);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->slider_z, record.slider_z);
  EXPECT_EQ(read->onsets, record.onsets);
  EXPECT_EQ(read->normal_force, record.normal_force);
  EXPECT_EQ(read->tangential_force, record.tangential_force);
  EXPECT_EQ(read->contact_area, record.contact_area);
  EXPECT_EQ(read->stick_share, record.stick_share);
  EXPECT_EQ(read->slip, record.slip);
  ASSERT_EQ(read->metrics.size(), record.metrics.size());
  EXPECT_EQ(read->metrics[0].name, "contact_area_slide");
  EXPECT_EQ(read->metrics[0].value, record.metrics[0].value);
  EXPECT_EQ(read->metrics[0].unit, "m2");
  ASSERT_EQ(read->coarser_solutions.size(), 1u);
  const MechanicsRecord& coarser_read = *read->coarser_solutions.at("mesh");
  EXPECT_EQ(coarser_read.normal_force, coarser->normal_force);
  EXPECT_EQ(coarser_read.metrics.size(), coarser->metrics.size());
  EXPECT_EQ(coarser_read.history.time, coarser->history.time);
  EXPECT_EQ(*coarser_read.history.shear()[20], *coarser->history.shear()[20]);
  EXPECT_EQ(read->join_time, record.join_time);
  EXPECT_EQ(read->warnings, record.warnings);
  EXPECT_EQ(read->electrode_stress, record.electrode_stress);
  EXPECT_EQ(read->history.time, record.history.time);
  EXPECT_EQ(read->history.event_time, record.history.event_time);
  EXPECT_EQ(*read->history.shear()[20], *record.history.shear()[20]);
  EXPECT_EQ(history::shear_integral(read->history, 1.2345),
            history::shear_integral(record.history, 1.2345));
  EXPECT_FALSE(read_mechanics(path, "other", input.skin));
}

TEST(MechanicsFile, GivesBackEverySlider) {
  const results::ScratchFolder folder;
  Case input = handover::small_case();
  input.slider.start[1] = 0.9e-3; // the whole skin is meshed
  input.further_sliders.push_back({input.slider, input.motion, input.contact});
  const auto contact = small_contact(cases_of_sliders(input).front());
  const auto record = make_mechanics_record(input, {contact, contact});
  ASSERT_EQ(record.further_sliders.size(), 1u);
  EXPECT_EQ(record.further_sliders[0].normal_force, record.normal_force);
  write_mechanics(folder / "results.h5", "hash", record);
  const auto read = read_mechanics(folder / "results.h5", "hash", input.skin);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->further_sliders.size(), 1u);
  EXPECT_EQ(read->further_sliders[0].normal_force, record.normal_force);
  EXPECT_EQ(read->further_sliders[0].slip, record.further_sliders[0].slip);
  EXPECT_EQ(read->history.frame, history::Frame::skin);
  EXPECT_EQ(*read->history.shear()[20], *record.history.shear()[20]);
}

TEST(MechanicsFile, ListsOfUnlikeLengthsAreDamage) {
  const results::ScratchFolder folder;
  const Case input = handover::small_case();
  const auto record = make_mechanics_record(input, small_contact(input));
  const std::vector<std::string> datasets{"/path/slider_z", "/path/slip", "/path/onset_end",
                                          "/path/metrics/value"};
  for (const std::string& dataset : datasets) {
    SCOPED_TRACE(dataset);
    write_mechanics(folder / "results.h5", "hash", record);
    {
      results::Hdf5File file(folder / "results.h5", results::Hdf5File::Access::modify);
      file.remove(dataset);
      file.write(dataset, std::vector<double>(1000, 1.0));
    }
    EXPECT_NE(results::message_of<UserError>([&] {
                read_mechanics(folder / "results.h5", "hash", input.skin);
              }).find(dataset),
              std::string::npos);
  }
}

TEST(MechanicsFile, DamageIsAnErrorOrFindsNothingWrong) {
  const results::ScratchFolder folder;
  const Case input = handover::small_case();
  write_mechanics(folder / "whole.h5", "hash", make_mechanics_record(input, small_contact(input)));
  const std::string whole = results::read_all(folder / "whole.h5");
  const std::uint32_t count = results::corruptions(40);
  for (std::uint32_t seed = 0; seed < count; ++seed) {
    SCOPED_TRACE(seed);
    results::write_all(folder / "results.h5", results::corrupted(whole, seed));
    try {
      read_mechanics(folder / "results.h5", "hash", input.skin);
    } catch (const UserError& error) {
      EXPECT_NE(std::string(error.what()).find("results.h5"), std::string::npos) << error.what();
    }
  }
}

TEST(MechanicsStore, PassesOverDamageAndSaysSo) {
  const results::ScratchFolder folder;
  const Case input = handover::small_case();
  const auto record = make_mechanics_record(input, small_contact(input));
  MechanicsStore store;
  for (const char* name : {"missing.h5", "changed.h5", "sealed.h5", "whole.h5"}) {
    const auto path = folder.path() / name;
    store.add("hash", path);
    if (path.stem() != "missing") {
      write_mechanics(path, "hash", record);
    }
  }
  const auto changed = folder.path() / "changed.h5", sealed = folder.path() / "sealed.h5",
             whole = folder.path() / "whole.h5";
  std::ofstream(changed, std::ios::app) << "x";
  {
    results::Hdf5File file(sealed, results::Hdf5File::Access::modify);
    file.remove("/path/slip");
  }
  base::seal(sealed);

  EXPECT_FALSE(MechanicsStore::holds(folder.path() / "missing.h5", "hash"));
  EXPECT_FALSE(MechanicsStore::holds(changed, "hash"));
  EXPECT_TRUE(MechanicsStore::holds(whole, "hash"));
  EXPECT_FALSE(MechanicsStore::holds(whole, "other"));
  EXPECT_FALSE(store.read("other", input.skin));
  EXPECT_TRUE(store.notes().empty());
  const auto read = store.read("hash", input.skin);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->normal_force, record.normal_force);
  ASSERT_EQ(store.notes().size(), 2u);
  EXPECT_EQ(store.notes()[0], "changed.h5 was damaged: what it held is done again.");
  EXPECT_NE(store.notes()[1].find("sealed.h5"), std::string::npos);
  ASSERT_TRUE(store.read("hash", input.skin));
  EXPECT_EQ(store.notes().size(), 2u); // files that failed are not asked again
}

} // namespace
} // namespace ionskin::study
