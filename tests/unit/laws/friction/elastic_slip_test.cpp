// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/elastic_slip.hpp"

#include "ionskin/laws/friction/return_mapping.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace ionskin::laws {
namespace {

constexpr double slip_length = 1e-7; // m
constexpr double time_step = 1e-3;   // s

Friction regularised() {
  return friction("regularised", 0.3, {{"slip_length", slip_length}});
}

/// All laws, with parameters that matter to the pressures and ways below.
std::vector<Friction> all_laws() {
  return {friction("coulomb", 0.3, {}),
          friction("saturating", 0.3, {{"strength", 4e5}, {"sharpness", 2}}),
          regularised(),
          friction("regularised", 0.3, {{"slip_length", 1e-8}}),
          friction("viscous", 0.3, {{"reference_speed", 1e-4}}),
          friction("stribeck", 0.3,
                   {{"kinetic_friction", 0.1}, {"stribeck_speed", 1e-4}, {"lag_time", 5e-3}}),
          friction("anisotropic", 0.3, {{"transverse_friction", 0.1}}),
          friction("adhesive", 0.3, {{"work_of_adhesion", 1}, {"cohesive_strength", 1e6}})};
}

/// One cell of a skin that gives by a compliance, and a slider that is moved over it.
class Cell {
public:
  explicit Cell(Friction law, double compliance = 2e-13)
      : law_(std::move(law)), compliance_(compliance) {}

  /// @returns what friction dissipates, at the traction behind the step [J/m2]
  double move(const TangentialVector& way, double pressure) {
    const FrictionArguments at{pressure, 0, time_step, lagged_};
    const TangentialVector before = traction;
    double dissipated = stored();
    traction =
        return_mapping(law_, {pressure,
                              {before[0] + way[0] / compliance_, before[1] + way[1] / compliance_},
                              compliance_,
                              time_step,
                              lagged_,
                              elastic_})
            .traction;
    TangentialVector slip{};
    for (std::size_t c = 0; c < 2; ++c) {
      slip[c] = way[c] - compliance_ * (traction[c] - before[c]);
      dissipated += traction[c] * slip[c];
      work += 0.5 * (before[c] + traction[c]) * way[c];
      moved += std::abs(traction[c] * way[c]);
    }
    elastic_ = divided_slip(law_, elastic_, at, slip).elastic;
    if (law_.lag > 0) {
      const double left = std::exp(-time_step / law_.lag);
      lagged_ = left * lagged_ + (1 - left) * std::hypot(slip[0], slip[1]) / time_step;
    }
    full_ =
        law_.elastic_slip > 0 ? law_.limit({pressure, law_.elastic_slip, time_step, lagged_}) : 0.0;
    return dissipated - stored();
  }

  /// Energy that is stored at the present traction and stiffness, whatever slip made them.
  double stored() const {
    return full_ > 0 ? 0.5 * law_.elastic_slip / full_ *
                           (traction[0] * traction[0] + traction[1] * traction[1])
                     : 0.0;
  }

  TangentialVector traction{}; ///< [Pa]
  double work = 0;             ///< of the slider, by the trapezoidal rule [J/m2]
  double moved = 0;            ///< sum of the magnitudes of work [J/m2]

private:
  Friction law_;
  double compliance_; ///< of the skin [m/Pa]
  ElasticSlip elastic_;
  double lagged_ = 0, full_ = 0;
};

TEST(ElasticSlip, EveryLawOnlyTakesEnergyInEveryStepOfAnyHistory) {
  for (const Friction& law : all_laws()) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int history = 0; history < 50; ++history) {
      Cell cell(law);
      const double far = std::pow(10, -8 + history % 4); // 10 nm to 10 um
      double pressure = 1e6;
      for (int i = 0; i < 400; ++i) {
        if (unit(random) > 0) {
          pressure = std::max(0.0, 2e6 * std::pow(unit(random), 3) + 5e5);
        }
        const bool rests = unit(random) > 0.5;
        const double dissipated = cell.move(
            rests ? TangentialVector{} : TangentialVector{far * unit(random), far * unit(random)},
            pressure);
        ASSERT_GE(dissipated, -1e-12 * (cell.moved + cell.stored())) << law.law << " step " << i;
      }
    }
  }
}

/// The slider is moved a way and back, under one pressure there and another one back, in fine
/// steps.
double work_of_cycles(const Friction& law, double pressure_there, double pressure_back,
                      double way) {
  Cell cell(law);
  constexpr int steps = 400, cycles = 5;
  const auto press = [&](double from, double to) {
    for (int i = 1; i <= steps; ++i) {
      cell.move({}, from + (to - from) * i / steps);
    }
  };
  const auto go = [&](double by, double pressure) {
    for (int i = 0; i < steps; ++i) {
      cell.move({by / steps, 0.5 * by / steps}, pressure);
    }
  };
  press(0, pressure_there);
  for (int i = 0; i < cycles; ++i) {
    go(way, pressure_there);
    press(pressure_there, pressure_back);
    go(-way, pressure_back);
    press(pressure_back, pressure_there);
  }
  press(pressure_there, 0);
  return cell.work / cell.moved;
}

TEST(ElasticSlip, NoClosedCycleGivesEnergyUnderAnyLaw) {
  for (const Friction& law : all_laws()) {
    for (const double way : {0.3e-7, 1e-7, 1e-6}) {
      EXPECT_GE(work_of_cycles(law, 1e5, 2e6, way), -1e-3) << law.law << way;
      EXPECT_GE(work_of_cycles(law, 2e6, 1e5, way), -1e-3) << law.law << way;
    }
  }
}

TEST(ElasticSlip, UnderOnePressureIsGivenBackWhole) {
  Cell cell(regularised());
  cell.move({}, 1e6);
  cell.move({0.5e-7, 0.2e-7}, 1e6);
  EXPECT_GT(cell.work, 0);
  cell.move({-0.5e-7, -0.2e-7}, 1e6);
  EXPECT_NEAR(cell.traction[0], 0, 1e-6);
  EXPECT_NEAR(cell.work, 0, 1e-12 * cell.moved);
}

TEST(ElasticSlip, RisingPressureKeepsTheTractionAndFallingPressureTheSlip) {
  Cell cell(regularised(), 1e-19); // holds the slip
  cell.move({}, 1e6);
  cell.move({0.5e-7, 0}, 1e6);
  const double wound = cell.traction[0], stored = cell.stored();
  cell.move({}, 4e6);
  EXPECT_NEAR(cell.traction[0], wound, 1e-5 * wound);
  EXPECT_NEAR(cell.stored(), stored / 4, 1e-5 * stored);
  cell.move({}, 1e6);
  EXPECT_NEAR(cell.traction[0], wound / 4, 1e-5 * wound);
  EXPECT_NEAR(cell.stored(), stored / 16, 1e-5 * stored);
}

TEST(ElasticSlip, OfARisingLimitDoesNotDependOnTheSteps) {
  const Friction law = regularised();
  constexpr double way = 0.8e-7, pressure = 2e6;
  for (const int steps : {1, 3, 50}) {
    ElasticSlip elastic;
    for (int i = 1; i <= steps; ++i) {
      elastic =
          divided_slip(law, elastic, {pressure * i / steps, 0, time_step, 0}, {way / steps, 0})
              .elastic;
    }
    EXPECT_NEAR(elastic.slip[0], 0.5 * way, 1e-12 * way) << steps;
    EXPECT_NEAR(elastic.limit, 0.3 * pressure, 1e-3);
  }
}

TEST(ElasticSlip, WhatIsBeyondTheSlipLengthIsLost) {
  const Friction law = regularised();
  const ElasticSlip before{{0.6e-7, 0}, 3e5};
  const SlipDivision division = divided_slip(law, before, {1e6, 0, time_step, 0}, {2e-7, 0});
  EXPECT_NEAR(division.elastic.slip[0], slip_length, 1e-20);
  EXPECT_NEAR(division.lost, 1.6e-7, 1e-20);
  EXPECT_NEAR(stored_energy(law, division.elastic), 0.5 * 3e5 * slip_length, 1e-12);
  const SlipDivision open = divided_slip(law, before, {0, 0, time_step, 0}, {3e-8, 4e-8});
  EXPECT_EQ(open.elastic.slip, TangentialVector{});
  EXPECT_NEAR(open.lost, 5e-8, 1e-20);
}

} // namespace
} // namespace ionskin::laws
