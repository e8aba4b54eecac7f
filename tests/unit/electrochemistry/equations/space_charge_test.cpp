// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/equations/space_charge.hpp"

#include "ionskin/base/error.hpp"
#include "model_cases.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace ionskin::electrochemistry {
namespace {

TEST(SpaceCharge, NegativeFixedChargeTellsTimePlaceValueAndRemedy) {
  Case input = verification::model_case();
  const auto history = verification::linear_step_history(0.0, -12.0, {0.0, 1.0});
  try {
    check_fixed_charge(input, history);
    FAIL() << "no error";
  } catch (const SolverError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("negative: -2"), std::string::npos) << message;
    EXPECT_NE(message.find("t = 0 s"), std::string::npos) << message;
    EXPECT_NE(message.find("x = 7.5 mm"), std::string::npos) << message;
    EXPECT_NE(error.remedy().find("coupling.coefficient"), std::string::npos);
  }
}

TEST(SpaceCharge, OfMirroredPlacesTheFirstIsNamed) {
  const auto message = [](double near, double far) {
    history::CoreHistory history = verification::linear_step_history(0.0, 0.0, {0.0, 1.0});
    history.grid.y_edges = {0.0, 0.5 * history.width, history.width};
    const auto field =
        std::make_shared<const history::StrainField>(history::StrainField{0.0, 0.0, near, far});
    history.shear().assign(history.time.size(), field);
    try {
      check_fixed_charge(verification::model_case(), history);
    } catch (const SolverError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  const double lowest = -12.0, beside = lowest * (1 - 1e-13);
  EXPECT_NE(message(lowest, beside).find("negative"), std::string::npos);
  EXPECT_EQ(message(lowest, beside), message(beside, lowest));
  EXPECT_NE(message(lowest, 0.9 * lowest), message(0.9 * lowest, lowest));
}

TEST(SpaceCharge, ReleasedIonsMustFit) {
  Case input = verification::model_case();
  input.coupling.law = "pair-generation";
  input.electrochemistry.ion_model = IonModel::steric;
  input.electrochemistry.largest_concentration = 2000.0;
  const auto history = verification::linear_step_history(0.0, 7.0, {0.0, 1.0});
  try {
    check_fixed_charge(input, history);
    FAIL() << "no error";
  } catch (const SolverError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("fixed charge of 2040 mol/m3 at t = 0 s"), std::string::npos) << message;
    EXPECT_NE(error.remedy().find("largest_concentration"), std::string::npos);
  }
  input.coupling.law = "fixed-charge";
  EXPECT_NO_THROW(check_fixed_charge(input, history));
}

TEST(SpaceCharge, TheLargestHarmlessShearIsThatWhichLeavesNoFixedCharge) {
  const Case input = verification::model_case();
  const double limit = -1 / input.coupling.coefficient; // of N = N_0 (1 + coefficient shear)
  const auto history = [](double shear) {
    return verification::linear_step_history(0.0, shear, {0.0, 1.0});
  };
  EXPECT_NO_THROW(check_fixed_charge(input, history(0.999 * limit)));
  EXPECT_THROW(check_fixed_charge(input, history(1.001 * limit)), SolverError);
}

} // namespace
} // namespace ionskin::electrochemistry
