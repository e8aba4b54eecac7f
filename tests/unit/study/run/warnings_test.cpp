// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/run/warnings.hpp"

#include "synthetic_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace ionskin::study {
namespace {

bool any_holds(const std::vector<std::string>& warnings, const std::string& words) {
  return std::any_of(warnings.begin(), warnings.end(), [&](const std::string& warning) {
    return warning.find(words) != std::string::npos;
  });
}

class WarningsTest : public testing::Test {
protected:
  WarningsTest() {
    input.electrochemistry = {293.15, 7e-11, 2e-3, 1200, 1};
    input.coupling.coefficient = 0.1;
    ions.min_concentration = {1200, 900};
    signals.columns = {{"time", "s", {0, 1, 2}},
                       {"p99_shear", "1", {0, 1e-4, 1e-4}},
                       {"current_common", "A", {0, 5e-3, -5e-3}},
                       {"current_difference", "A", {0, 1e-4, 1e-4}}};
  }
  Case input = handover::small_case();
  MechanicsRecord mechanics;
  electrochemistry::IonSolution ions;
  readout::SignalTable signals;
};

TEST_F(WarningsTest, SaysThatTheCouplingIsUncalibrated) {
  EXPECT_TRUE(any_holds(collect_warnings(input, mechanics, ions, signals), "not calibrated"));
  input.coupling.coefficient = 0;
  EXPECT_FALSE(any_holds(collect_warnings(input, mechanics, ions, signals), "not calibrated"));
}

TEST_F(WarningsTest, SaysThatTheCommonPartDominates) {
  EXPECT_TRUE(any_holds(collect_warnings(input, mechanics, ions, signals), "50 times"));
  input.coupling.law = "column-neutral";
  EXPECT_FALSE(any_holds(collect_warnings(input, mechanics, ions, signals), "common part"));
}

TEST_F(WarningsTest, SaysHowNonlinearTheResponseIs) {
  EXPECT_FALSE(any_holds(collect_warnings(input, mechanics, ions, signals), "nonlinear"));
  signals.columns[1].values[1] = 0.05;
  EXPECT_TRUE(any_holds(collect_warnings(input, mechanics, ions, signals), "nonlinear"));
}

TEST_F(WarningsTest, SaysThatDoubleLayersOverlap) {
  EXPECT_FALSE(any_holds(collect_warnings(input, mechanics, ions, signals), "Debye lengths"));
  input.electrochemistry.permittivity *= 1e6;
  EXPECT_TRUE(any_holds(collect_warnings(input, mechanics, ions, signals), "Debye lengths"));
}

TEST_F(WarningsTest, SaysWhereTheLawOfTheWaterEnds) {
  input.coupling = {};
  input.coupling.law = "poroelastic";
  input.water.drag_number = 2.5;
  input.water.drained_poissons_ratio = 0.1;
  input.water.mobility = 1e-20;
  ions.water.largest_drive = {0, 0.4};
  EXPECT_TRUE(any_holds(collect_warnings(input, mechanics, ions, signals), "self-diffusivity"));
  EXPECT_FALSE(any_holds(collect_warnings(input, mechanics, ions, signals), "Press with less"));
  ions.water.largest_drive = {0, 0.6};
  EXPECT_TRUE(any_holds(collect_warnings(input, mechanics, ions, signals), "reaches 0.6"));
}

TEST_F(WarningsTest, NamesTheTaxelWhoseEdgeCutsAColumn) {
  ions.grid.x_edges = {0, 1e-3, 2e-3, 3e-3};
  ions.grid.y_edges = {0, 1e-3, 2e-3};
  input.readout.taxels = {{"left", {0, 0}, {1e-3, 2e-3}}, {"right", {1e-3, 0}, {3e-3, 2e-3}}};
  EXPECT_FALSE(any_holds(collect_warnings(input, mechanics, ions, signals), "taxel"));
  input.readout.taxels[1].lower[0] = 1.4e-3;
  EXPECT_TRUE(any_holds(collect_warnings(input, mechanics, ions, signals),
                        "the taxel right lies inside a column of the transport grid, 25 %"));
}

TEST_F(WarningsTest, NamesTheVoltageWhereNothingHoldsThePotential) {
  for (const char* circuit : {"open", "load"}) {
    input.readout.circuit = circuit;
    const auto warnings = collect_warnings(input, mechanics, ions, signals);
    EXPECT_TRUE(any_holds(warnings, "reads voltage only")) << circuit;
    EXPECT_FALSE(any_holds(warnings, "times the difference")) << circuit;
  }
}

TEST_F(WarningsTest, OrdersByWhatTheyChange) {
  signals.columns[1].values[1] = 0.05;
  input.notes = {"a note"};
  const auto warnings = collect_warnings(input, mechanics, ions, signals);
  ASSERT_EQ(warnings.size(), 4u);
  EXPECT_NE(warnings[0].find("nonlinear"), std::string::npos);
  EXPECT_NE(warnings[1].find("common part"), std::string::npos);
  EXPECT_EQ(warnings[2], "a note");
  EXPECT_NE(warnings[3].find("not calibrated"), std::string::npos);
}

TEST_F(WarningsTest, SaysThatCationsAreDepleted) {
  EXPECT_FALSE(any_holds(collect_warnings(input, mechanics, ions, signals), "depleted"));
  ions.min_concentration[1] = 60;
  EXPECT_TRUE(any_holds(collect_warnings(input, mechanics, ions, signals), "depleted"));
}

TEST_F(WarningsTest, SaysThatTheReadingIsUncertain) {
  ErrorEstimate errors;
  EXPECT_TRUE(error_warnings(input, errors).empty());
  errors.relative = {{"tail_current_difference", 0.19}};
  EXPECT_TRUE(error_warnings(input, errors).empty());
  errors.relative = {{"tail_current_difference", 0.22},
                     {"peak_sampled_current_difference", 0.36},
                     {"mean_shear_slide", 0.01}};
  EXPECT_TRUE(any_holds(error_warnings(input, errors),
                        "20 % for peak_sampled_current_difference (36 %), "
                        "tail_current_difference (22 %). Choose"));
  input.readout.circuit = "open";
  EXPECT_TRUE(error_warnings(input, errors).empty());
  errors.relative["peak_voltage"] = 0.3;
  EXPECT_TRUE(any_holds(error_warnings(input, errors), "peak_voltage (30 %)"));
  errors.not_converging = {{"peak_voltage", "a reason"}};
  EXPECT_TRUE(error_warnings(input, errors).empty());
}

TEST_F(WarningsTest, LeavesErrorsOfWhatIsNotReadToTheTableOfNumbers) {
  ErrorEstimate errors;
  errors.relative = {
      {"stick_fraction_touchdown", 4.81}, {"p99_shear_slide", 0.4}, {"rms_current_common", 9.1}};
  EXPECT_TRUE(error_warnings(input, errors).empty());
}

TEST_F(WarningsTest, NamesMissingErrors) {
  ErrorEstimate errors;
  errors.not_estimated = {{"max_potential", not_a_number}, {"energy_balance_error", "an audit"}};
  ASSERT_EQ(error_warnings(input, errors).size(), 1u);
  EXPECT_TRUE(any_holds(error_warnings(input, errors), "max_potential is not estimated"));
}

TEST_F(WarningsTest, SaysHowHardTheSliderPresses) {
  mechanics.normal_force = {0, 68};
  EXPECT_TRUE(any_holds(mechanics_warnings(input, mechanics), "15.1 MPa"));
  mechanics.normal_force = {0, 1};
  EXPECT_FALSE(any_holds(mechanics_warnings(input, mechanics), "MPa"));
}

} // namespace
} // namespace ionskin::study
