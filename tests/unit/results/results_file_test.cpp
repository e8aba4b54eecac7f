// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/results_file.hpp"

#include "scratch_folder.hpp"
#include "strain_example.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::results {
namespace {

using Start = ResultsFile::Start;

readout::SignalTable signals() {
  readout::SignalTable table;
  table.cycle = {1, 1};
  table.phase = {"touchdown", "slide"};
  table.columns = {{"time", "s", {0, 1}}, {"current_top", "A", {0, 2e-7}}};
  return table;
}

Hdf5File opened(const std::filesystem::path& path) {
  return {path, Hdf5File::Access::read};
}

TEST(ResultsFile, HoldsSignalsWithUnits) {
  const ScratchFolder folder;
  ResultsFile results(folder / "results.h5", Start::empty);
  results.write_signals("signals", signals());
  results.commit();
  const Hdf5File file = opened(folder / "results.h5");
  EXPECT_EQ(file.read("/signals/current_top"), (std::vector<double>{0, 2e-7}));
  EXPECT_EQ(file.text_attribute("/signals/current_top", "unit"), "A");
  EXPECT_EQ(file.read("/signals/cycle"), (std::vector<double>{1, 1}));
  EXPECT_EQ(file.read_texts("/signals/phase"), (std::vector<std::string>{"touchdown", "slide"}));
}

TEST(ResultsFile, HoldsIonFieldsByInstant) {
  const ScratchFolder folder;
  const electrochemistry::TransportGrid grid{{0, 1, 2}, {0, 1}, {0, 1, 2}};
  electrochemistry::IonSnapshot snapshot;
  snapshot.time = 1.5;
  snapshot.concentration = {1, 2, 3, 4, 5, 6};
  snapshot.potential = snapshot.shear = std::vector<double>(6, 0.5);
  ResultsFile results(folder / "results.h5", Start::empty);
  results.write_ions(grid, {snapshot});
  results.commit();
  const Hdf5File file = opened(folder / "results.h5");
  EXPECT_EQ(file.shape("/ions/1.5/concentration"), (Hdf5File::Shape{1, 3, 1, 2}));
  EXPECT_EQ(file.read("/ions/1.5/concentration"), snapshot.concentration);
  EXPECT_EQ(file.text_attribute("/ions/1.5/potential", "unit"), "V");
  EXPECT_EQ(file.number_attribute("/ions/1.5", "time"), 1.5);
  EXPECT_EQ(file.read("/ions/grid/x"), grid.x_edges);
}

TEST(ResultsFile, StatesTheHeightsOfTheUnderside) {
  const ScratchFolder folder;
  Slider slider;
  slider.shape = "cylinder";
  slider.parameters = {{"radius", 8e-3}};
  slider.size = {4e-3, 2e-3};
  ResultsFile results(folder / "results.h5", Start::empty);
  results.write_slider(slider);
  results.commit();
  const Hdf5File file = opened(folder / "results.h5");
  const std::vector<double> x = file.read("/slider/x"), y = file.read("/slider/y"),
                            heights = file.read("/slider/height");
  EXPECT_DOUBLE_EQ(x.front(), -2e-3);
  EXPECT_DOUBLE_EQ(y.back(), 1e-3);
  EXPECT_EQ(file.shape("/slider/height"), (Hdf5File::Shape{y.size(), x.size()}));
  // The axis lies along y: all rows are alike, and rise as a circle.
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double rise = 8e-3 - std::sqrt(64e-6 - x[i] * x[i]);
    EXPECT_NEAR(heights[i], rise, 1e-15);
    EXPECT_EQ(heights[heights.size() - x.size() + i], heights[i]);
  }
  EXPECT_EQ(file.text_attribute("/slider/height", "unit"), "m");
}

TEST(ResultsFile, HoldsContactMapsByState) {
  const ScratchFolder folder;
  ContactMaps contact;
  contact.cell_lines_x = {-1e-3, 0, 1e-3};
  contact.cell_lines_y = {-5e-4, 0};
  contact.maps = {{"touchdown", 1.0, {1e7, 2e7}, {1, 2}, {3, 4}, {0, 0}, {1, 3}, {0, 2e-6}}};
  ResultsFile results(folder / "results.h5", Start::empty);
  results.write_contact(contact);
  results.commit();
  const Hdf5File file = opened(folder / "results.h5");
  EXPECT_EQ(file.shape("/contact/touchdown/pressure"), (Hdf5File::Shape{1, 2}));
  EXPECT_EQ(file.read("/contact/touchdown/shear_y"), (std::vector<double>{3, 4}));
  EXPECT_EQ(file.text_attribute("/contact/touchdown/slip", "unit"), "m");
  EXPECT_EQ(file.read("/contact/touchdown/slip_state"), (std::vector<double>{1, 3}));
  EXPECT_EQ(file.read("/contact/touchdown/slip_since_landing"), (std::vector<double>{0, 2e-6}));
  EXPECT_EQ(file.text_attribute("/contact/touchdown/slip_since_landing", "unit"), "m");
}

TEST(ResultsFile, IsExtendedAndItsPartsReplaced) {
  const ScratchFolder folder;
  {
    ResultsFile first(folder / "results.h5", Start::extend);
    first.write_strain(example_history(history::Frame::skin));
    first.write_text("manifest", "half");
    first.commit();
  }
  ResultsFile second(folder / "results.h5", Start::extend);
  second.write_signals("signals", signals());
  second.write_text("manifest", "whole");
  second.commit();
  const Hdf5File file = opened(folder / "results.h5");
  EXPECT_TRUE(file.has("/strain/gamma"));
  EXPECT_TRUE(file.has("/signals/time"));
  EXPECT_EQ(file.read_text("/manifest"), "whole");
}

TEST(ResultsFile, WhatIsNotCommittedLeavesTheOldFile) {
  const ScratchFolder folder;
  {
    ResultsFile first(folder / "results.h5", Start::empty);
    first.write_text("case", "old");
    first.commit();
  }
  {
    ResultsFile second(folder / "results.h5", Start::empty);
    second.write_text("case", "new");
  }
  EXPECT_EQ(opened(folder / "results.h5").read_text("/case"), "old");
  EXPECT_FALSE(std::filesystem::exists(folder / "results.h5.tmp"));
}

} // namespace
} // namespace ionskin::results
