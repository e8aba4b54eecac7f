// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/fit/fit_log.hpp"

#include "scratch_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace ionskin::study {
namespace {

TEST(FitLog, GivesBackEveryBitOfWhatAnEarlierFitFound) {
  const results::ScratchFolder scratch;
  results::OutputFolder folder(scratch.path() / "out", results::ExistingFolder::refuse);
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
  results::OutputFolder folder(scratch.path() / "out", results::ExistingFolder::refuse);
  {
    FitLog log(folder);
    log.add({1.0}, {std::vector<double>{2.0}, ""});
    log.add({2.0}, {std::vector<double>{3.0}, ""});
  }
  const auto entry = std::filesystem::directory_iterator(folder.file("evaluations"))->path();
  std::fstream(entry, std::ios::in | std::ios::out).seekp(2000).put('x');
  std::ofstream(folder.file("evaluations/half.h5")) << "no HDF5";
  std::ofstream(folder.file("evaluations/notes.txt")) << "a user's";
  FitLog log(folder);
  EXPECT_EQ(log.taken_up(), 1u);
  log.remove();
  EXPECT_TRUE(std::filesystem::exists(folder.file("evaluations/notes.txt")));
  EXPECT_TRUE(std::filesystem::exists(folder.file("evaluations/half.h5")));
  EXPECT_FALSE(std::filesystem::exists(entry));
}

} // namespace
} // namespace ionskin::study
