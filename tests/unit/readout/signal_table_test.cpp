// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/signal_table.hpp"

#include "ionskin/base/error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::readout {
namespace {

SignalInputs three_rows() {
  SignalInputs inputs;
  inputs.time = {0, 1, 3};
  inputs.mean_shear = {0, 0.1, 0.5};
  inputs.rms_shear = inputs.p99_shear = inputs.shear_first_moment = {0, 0, 0};
  inputs.charge_top = {0, 2, 2};
  inputs.charge_bottom = {0, 1, -1};
  return inputs;
}

TEST(SignalTable, HasTheColumnsOfSignalsCsvInOrder) {
  const SignalTable table = build_signal_table(three_rows());
  std::vector<std::string> names;
  for (const Signal& column : table.columns) {
    names.push_back(column.name + " [" + column.unit + "]");
    EXPECT_EQ(column.values.size(), 3u) << column.name;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"time [s]",
                                             "slider_x [m]",
                                             "slider_z [m]",
                                             "normal_force [N]",
                                             "tangential_force [N]",
                                             "mean_shear [1]",
                                             "rms_shear [1]",
                                             "p99_shear [1]",
                                             "shear_first_moment [1]",
                                             "mean_shear_rate [1/s]",
                                             "charge_top [C]",
                                             "charge_bottom [C]",
                                             "current_top [A]",
                                             "current_bottom [A]",
                                             "current_difference [A]",
                                             "current_common [A]",
                                             "slider_y [m]",
                                             "contact_area [m2]",
                                             "stick_share [1]",
                                             "slip [m]",
                                             "slip_state [1]",
                                             "tangential_force_x [N]",
                                             "tangential_force_y [N]",
                                             "moment_x [N m]",
                                             "moment_y [N m]",
                                             "moment_z [N m]"}));
}

TEST(SignalTable, RatesAndCurrentsAreMeansOverTheStepThatEndsAtTheRow) {
  const SignalTable table = build_signal_table(three_rows());
  EXPECT_EQ(table.column("mean_shear_rate").values, (std::vector<double>{0, 0.1, 0.2}));
  EXPECT_EQ(table.column("current_difference").values, (std::vector<double>{0, 0.5, 0.5}));
}

TEST(SignalTable, LeavesMotionAndForcesEmptyInRunsFromAStrainFile) {
  const SignalTable table = build_signal_table(three_rows());
  for (const char* name :
       {"slider_x", "slider_y", "slider_z", "normal_force", "tangential_force", "contact_area",
        "stick_share", "slip", "slip_state", "tangential_force_x", "tangential_force_y", "moment_x",
        "moment_y", "moment_z"}) {
    EXPECT_TRUE(std::isnan(table.column(name).values[1])) << name;
  }
  EXPECT_EQ(table.cycle, (std::vector<int>{0, 0, 0}));
  EXPECT_EQ(table.phase, (std::vector<std::string>{"", "", ""}));
}

TEST(SignalTable, TakesTheMotionAtEveryRow) {
  SignalInputs inputs = three_rows();
  Motion motion;
  motion.gap = 1;
  motion.touchdown = 1;
  motion.slide = 4;
  motion.stroke = 8;
  Slider slider;
  slider.start = {2, 0.5};
  add_motion(inputs, motion, slider);
  const SignalTable table = build_signal_table(inputs);
  EXPECT_EQ(table.phase, (std::vector<std::string>{"touchdown", "touchdown", "slide"}));
  EXPECT_EQ(table.column("slider_x").values, (std::vector<double>{2, 2, 6}));
  EXPECT_EQ(table.column("slider_y").values, (std::vector<double>{0.5, 0.5, 0.5}));
}

TEST(SignalTable, RefusesColumnsOfAnotherLength) {
  SignalInputs inputs = three_rows();
  inputs.normal_force = {1, 2};
  EXPECT_THROW(build_signal_table(inputs), InternalError);
  inputs = three_rows();
  inputs.charge_top.pop_back();
  EXPECT_THROW(build_signal_table(inputs), InternalError);
  EXPECT_THROW(build_signal_table(three_rows()).column("nothing"), InternalError);
}

} // namespace
} // namespace ionskin::readout
