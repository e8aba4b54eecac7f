// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/csv_writer.hpp"

#include "scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace ionskin::results {
namespace {

TEST(CsvWriter, HeaderHasUnitsAndPhasesStandBehindTime) {
  readout::SignalTable table;
  table.cycle = {1, 2};
  table.phase = {"touchdown", "return"};
  table.columns = {{"time", "s", {0, 0.5}}, {"normal_force", "N", {NAN, 65}}};
  EXPECT_EQ(csv_text(table), "time [s],cycle,phase,normal_force [N]\n"
                             "0,1,touchdown,\n"
                             "0.5,2,return,65\n");
}

TEST(CsvWriter, WithoutPhasesHasNumericColumnsOnly) {
  readout::SignalTable table;
  table.columns = {{"time", "s", {0.1}}, {"current_top", "A", {-2e-7}}};
  EXPECT_EQ(csv_text(table), "time [s],current_top [A]\n0.1,-2e-07\n");
}

TEST(CsvWriter, RunsFromAStrainFileLeaveCycleAndPhaseEmpty) {
  readout::SignalTable table;
  table.cycle = {0};
  table.phase = {""};
  table.columns = {{"time", "s", {1}}};
  EXPECT_EQ(csv_text(table), "time [s],cycle,phase\n1,,\n");
}

TEST(CsvWriter, NumbersReadBackExactly) {
  const std::vector<double> values{0.1 + 0.2, 1.0 / 3, -6.02214076e23, 4.9e-324, 1e-9 / 7};
  readout::SignalTable table;
  table.columns = {{"time", "s", values}};
  const ScratchFolder folder;
  write_csv(folder / "signals.csv", table);
  std::ifstream stream(folder / "signals.csv");
  std::string line;
  std::getline(stream, line);
  for (double value : values) {
    std::getline(stream, line);
    EXPECT_EQ(std::strtod(line.c_str(), nullptr), value);
  }
}

} // namespace
} // namespace ionskin::results
