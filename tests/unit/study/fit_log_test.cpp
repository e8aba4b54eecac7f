// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/fit_log.hpp"

#include "scratch_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace ionskin::study {
namespace {

TEST(FitLog, GivesBackEveryBitOfWhatAnEarlierFitFound) {
  const results::ScratchFolder scratch;
  const auto folder = scratch.path() / "evaluations";
  const std::vector<double> point{0.1, 1.0 / 3}, beside{0.1, 1.0 / 3 + 1e-16}, hopeless{-1, 0};
  {
    FitLog log(folder);
    EXPECT_FALSE(log.find(point));
    log.add(point, {std::vector<double>{1e-300, -0.1, 1.0 / 3}, ""});
    log.add(hopeless, {std::nullopt, "no solution"});
    EXPECT_EQ(log.taken_up(), 0u);
  }
  FitLog log(folder);
  EXPECT_EQ(log.taken_up(), 2u);
  EXPECT_EQ(log.find(point)->values, (std::vector<double>{1e-300, -0.1, 1.0 / 3}));
  EXPECT_FALSE(log.find(beside));
  EXPECT_FALSE(log.find(hopeless)->values);
  EXPECT_EQ(log.find(hopeless)->failure, "no solution");
}

TEST(FitLog, PassesOverDamagedFilesAndLeavesForeignOnes) {
  const results::ScratchFolder scratch;
  const auto folder = scratch.path() / "evaluations";
  {
    FitLog log(folder);
    log.add({1.0}, {std::vector<double>{2.0}, ""});
  }
  std::ofstream(folder / "half.h5") << "no HDF5";
  std::ofstream(folder / "notes.txt") << "a user's";
  FitLog log(folder);
  EXPECT_EQ(log.taken_up(), 1u);
  log.remove();
  EXPECT_TRUE(std::filesystem::exists(folder / "notes.txt"));
  EXPECT_FALSE(std::filesystem::exists(folder / "half.h5"));
}

} // namespace
} // namespace ionskin::study
