// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/fit/fit_log.hpp"

#include "scratch_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace ionskin::study {
namespace {

FitAnswer answer(std::vector<double> time) {
  electrochemistry::IonSolution ions;
  ions.charge_top = {-0.1, 5e-324};
  ions.time = std::move(time);
  return fit_answer(ions);
}

TEST(FitLog, GivesBackEveryBitOfWhatAnEarlierFitFound) {
  const results::ScratchFolder scratch;
  results::OutputFolder folder(scratch.path() / "out", results::ExistingFolder::refuse);
  const std::vector<double> point{0.1, 1.0 / 3}, beside{0.1, 1.0 / 3 + 1e-16}, hopeless{-1, 0};
  {
    FitLog log(folder);
    EXPECT_FALSE(log.find(point));
    log.add(point, answer({1e-300, 1.0 / 3}));
    log.add({}, answer({2}));
    log.add(hopeless, {nullptr, "no solution"});
    EXPECT_EQ(log.taken_up(), 0u);
  }
  FitLog log(folder);
  EXPECT_EQ(log.taken_up(), 3u);
  EXPECT_EQ(log.find(point)->ions->time, (std::vector<double>{1e-300, 1.0 / 3}));
  EXPECT_EQ(log.find(point)->ions->charge_top, (std::vector<double>{-0.1, 5e-324}));
  EXPECT_TRUE(log.find(point)->ions->voltage.empty());
  EXPECT_EQ(log.find({})->ions->time, (std::vector<double>{2}));
  EXPECT_FALSE(log.find(beside));
  EXPECT_FALSE(log.find(hopeless)->ions);
  EXPECT_EQ(log.find(hopeless)->failure, "no solution");
}

TEST(FitLog, KeepsTheTaxelThatTheDataAreOf) {
  const results::ScratchFolder scratch;
  results::OutputFolder folder(scratch.path() / "out", results::ExistingFolder::refuse);
  electrochemistry::IonSolution ions;
  ions.time = {1, 2};
  ions.top_segments = {{"a", {1, 2}, {3, 4}, {}, {}, {}},
                       {"b", {5, 6}, {}, {0.1, 0.2}, {7, 8}, {9}}};
  {
    FitLog log(folder);
    log.add({1.0}, fit_answer(ions, "b"));
    log.add({2.0}, fit_answer(ions));
  }
  FitLog log(folder);
  EXPECT_TRUE(log.find({2.0})->ions->top_segments.empty());
  const auto& kept = log.find({1.0})->ions->top_segments;
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept[0].name, "b");
  EXPECT_EQ(kept[0].charge, (std::vector<double>{5, 6}));
  EXPECT_EQ(kept[0].voltage, (std::vector<double>{0.1, 0.2}));
  EXPECT_EQ(kept[0].passed, (std::vector<double>{7, 8}));
}

TEST(FitLog, PassesOverDamagedFilesAndLeavesForeignOnes) {
  const results::ScratchFolder scratch;
  results::OutputFolder folder(scratch.path() / "out", results::ExistingFolder::refuse);
  {
    FitLog log(folder);
    log.add({1.0}, answer({2}));
    log.add({2.0}, answer({3}));
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
