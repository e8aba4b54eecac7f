// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/store/checkpoint_file.hpp"

#include "corruption.hpp"
#include "ionskin/base/error.hpp"
#include "scratch_folder.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace ionskin::study {
namespace {

electrochemistry::IonCheckpoint example() {
  electrochemistry::IonCheckpoint checkpoint;
  checkpoint.step = 1;
  checkpoint.state.ions.values = {1.0, 1.0 / 3, 2e-300, -0.1};
  checkpoint.state.rate = {0.25, -1e-7, 3.0, 0.0};
  checkpoint.state.next_step = 1e-3;
  checkpoint.solution.grid = {{0, 1}, {0, 2}, {0, 0.1, 0.2}};
  checkpoint.solution.time = {0, 0.1};
  checkpoint.solution.charge_top = {0, 1e-9 / 7};
  checkpoint.solution.relaxation_current = {0, 2e-9 / 7};
  checkpoint.solution.krylov_iterations = 1234;
  checkpoint.solution.top_segments = {{"left", {1e-9, 2e-9}, {0, 0}},
                                      {"rest", {3e-9, 1e-9 / 3}, {1e-9 / 7, 2e-9}}};
  checkpoint.solution.lines = {{"c1", {1e-9, 2e-9}, {}, {0, 1e-3 / 3}, {0, 1e-9 / 11}, {}}};
  checkpoint.solution.snapshots = {{0.1, {1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {1.0 / 3}, {2.0 / 3}}};
  checkpoint.solution.water.dilution_voltage = {0, 1e-6 / 3};
  return checkpoint;
}

TEST(CheckpointFile, GivesBackEveryBit) {
  const results::ScratchFolder folder;
  const auto written = example();
  write_checkpoint(folder.path() / "checkpoint.h5", "hash", written);
  const auto read = read_checkpoint(folder.path() / "checkpoint.h5", "hash");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->step, written.step);
  EXPECT_EQ(read->state.ions.values, written.state.ions.values);
  EXPECT_EQ(read->state.rate, written.state.rate);
  EXPECT_EQ(read->solution.grid.z_nodes, written.solution.grid.z_nodes);
  EXPECT_EQ(read->solution.charge_top, written.solution.charge_top);
  EXPECT_EQ(read->solution.relaxation_current, written.solution.relaxation_current);
  EXPECT_EQ(read->solution.krylov_iterations, written.solution.krylov_iterations);
  ASSERT_EQ(read->solution.top_segments.size(), 2u);
  EXPECT_EQ(read->solution.top_segments[1].name, "rest");
  EXPECT_EQ(read->solution.top_segments[1].charge, written.solution.top_segments[1].charge);
  ASSERT_EQ(read->solution.lines.size(), 1u);
  EXPECT_EQ(read->solution.lines[0].name, "c1");
  EXPECT_EQ(read->solution.lines[0].charge, written.solution.lines[0].charge);
  EXPECT_EQ(read->solution.lines[0].voltage, written.solution.lines[0].voltage);
  EXPECT_EQ(read->solution.lines[0].passed, written.solution.lines[0].passed);
  ASSERT_EQ(read->solution.snapshots.size(), 1u);
  EXPECT_EQ(read->solution.snapshots[0].time, 0.1);
  EXPECT_EQ(read->solution.snapshots[0].potential, written.solution.snapshots[0].potential);
  EXPECT_EQ(read->solution.snapshots[0].swelling, written.solution.snapshots[0].swelling);
  EXPECT_EQ(read->solution.top_segments[1].bottom_charge,
            written.solution.top_segments[1].bottom_charge);
  EXPECT_EQ(read->solution.water.dilution_voltage, written.solution.water.dilution_voltage);
  EXPECT_TRUE(read->solution.water.largest_drive.empty());
}

TEST(CheckpointFile, GivesBackTheWater) {
  const results::ScratchFolder folder;
  auto written = example();
  write_checkpoint(folder.path() / "checkpoint.h5", "hash", written);
  EXPECT_FALSE(read_checkpoint(folder.path() / "checkpoint.h5", "hash")->state.memory);
  written.state.memory = {0.1, {{1.0 / 3, -2e5}, {1e-300, 7.0 / 9}}, {{2.0 / 3}, {1.0 / 7}}};
  write_checkpoint(folder.path() / "checkpoint.h5", "hash", written);
  const auto read = read_checkpoint(folder.path() / "checkpoint.h5", "hash");
  ASSERT_TRUE(read && read->state.memory);
  EXPECT_EQ(read->state.memory->time, 0.1);
  EXPECT_EQ(read->state.memory->pressure.pressure, written.state.memory->pressure.pressure);
  EXPECT_EQ(read->state.memory->pressure.undrained, written.state.memory->pressure.undrained);
  EXPECT_EQ(read->state.memory->dragged.pressure, written.state.memory->dragged.pressure);
  EXPECT_EQ(read->state.memory->dragged.undrained, written.state.memory->dragged.undrained);
}

TEST(CheckpointFile, IsNotTakenForAnotherCase) {
  const results::ScratchFolder folder;
  EXPECT_FALSE(read_checkpoint(folder.path() / "checkpoint.h5", "hash"));
  write_checkpoint(folder.path() / "checkpoint.h5", "hash", example());
  EXPECT_FALSE(read_checkpoint(folder.path() / "checkpoint.h5", "other"));
}

TEST(CheckpointFile, DamageIsAnErrorOrFindsNothingWrong) {
  const results::ScratchFolder folder;
  write_checkpoint(folder / "whole.h5", "hash", example());
  const std::string whole = results::read_all(folder / "whole.h5");
  const std::uint32_t count = results::corruptions(40);
  for (std::uint32_t seed = 0; seed < count; ++seed) {
    SCOPED_TRACE(seed);
    results::write_all(folder / "checkpoint.h5", results::corrupted(whole, seed));
    try {
      read_checkpoint(folder / "checkpoint.h5", "hash");
    } catch (const UserError& error) {
      EXPECT_NE(std::string(error.what()).find("checkpoint.h5"), std::string::npos) << error.what();
    }
  }
}

TEST(CheckpointFile, IsNotTakenWhenItCannotBeContinued) {
  const results::ScratchFolder folder;
  const auto path = folder.path() / "checkpoint.h5";
  const auto is_taken = [&](const electrochemistry::IonCheckpoint& checkpoint) {
    write_checkpoint(path, "hash", checkpoint);
    return read_checkpoint(path, "hash").has_value();
  };
  auto spoilt = example();
  spoilt.state.next_step = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(is_taken(spoilt));
  spoilt = example();
  spoilt.state.rate.pop_back();
  EXPECT_FALSE(is_taken(spoilt));
  spoilt = example();
  spoilt.state.memory = {0.1, {{1.0}, {std::numeric_limits<double>::infinity()}}};
  EXPECT_FALSE(is_taken(spoilt));
  spoilt.state.memory = {0.1, {{1.0}, {1.0, 2.0}}};
  EXPECT_FALSE(is_taken(spoilt));
  spoilt = example();
  spoilt.solution.time = {0};
  EXPECT_FALSE(is_taken(spoilt));
  ASSERT_TRUE(is_taken(example()));
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  EXPECT_FALSE(read_checkpoint(path, "hash"));
}

} // namespace
} // namespace ionskin::study
