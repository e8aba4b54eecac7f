// SPDX-License-Identifier: Apache-2.0
#include "ionskin/poroelasticity/pore_pressure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace ionskin::poroelasticity {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// One time of 2 s in which half of the shear modulus goes.
Relaxation maxwell(RelaxingLoad load) {
  return {{2.0}, {0.15}, 0.3, 4.0 / 3, 5.0, load};
}

/// Four times beside one that is as good as that of the water.
Relaxation several(RelaxingLoad load) {
  return {{1e-3, 1.0, 1.0000001, 1e4}, {0.02, 0.05, 0.05, 0.1}, 0.3, 1.0 / 3, 12.0, load};
}

double sum_at(const std::vector<double>& weights, const std::vector<double>& rates, double time) {
  double sum = 0;
  for (std::size_t j = 0; j < rates.size(); ++j) {
    sum += weights[j] * std::exp(-rates[j] * time);
  }
  return sum;
}

double pressure_at(const Relaxation& core, double diffusion, double time) {
  const StepResponse response = step_response(core, diffusion);
  return sum_at(response.pressure, response.rate, time);
}

double undrained_at(const Relaxation& core, double diffusion, double time) {
  const StepResponse response = step_response(core, diffusion);
  return response.undrained_directly + sum_at(response.undrained, response.rate, time);
}

TEST(Relaxation, WithoutTimesIsTheElasticDecay) {
  EXPECT_DOUBLE_EQ(pressure_at({}, 3.0, 0.2), std::exp(-0.6));
  EXPECT_EQ(undrained_at({}, 3.0, 0.2), 1.0);
  EXPECT_EQ(pressure_at({}, infinite, 0.0), 0.0);
}

// Where no water moves, P is G/(K_u + G dM/dG) of the Maxwell solid: one decay.
TEST(Relaxation, UndrainedPressureOfAStrainFollowsTheModulus) {
  const Relaxation core = maxwell(RelaxingLoad::strain);
  const double whole = 1 + core.storage, relaxed = whole - 0.2; // K_u + dM/dG G, over M
  for (const double time : {0.0, 0.5, 2.0, 20.0, 1e6}) {
    const double end = 0.5 * whole / relaxed;
    const double expected = end + (1 - end) * std::exp(-time / 2 * relaxed / whole);
    EXPECT_NEAR(pressure_at(core, 0.0, time), expected, 1e-12) << time;
    EXPECT_NEAR(undrained_at(core, 0.0, time), expected, 1e-12) << time;
  }
}

// Where P is 0, the core creeps under the load: t = -p J(time).
TEST(Relaxation, DrainedCoreCreepsUnderAPressure) {
  const Relaxation core = maxwell(RelaxingLoad::pressure);
  const double relaxed = 1 - 0.2;
  for (const double time : {0.0, 0.5, 2.0, 20.0}) {
    const double creep = 1 / relaxed - (1 / relaxed - 1) * std::exp(-time / 2 * relaxed);
    EXPECT_NEAR(undrained_at(core, infinite, time), creep, 1e-12) << time;
    EXPECT_EQ(pressure_at(core, infinite, time), 0.0);
  }
}

TEST(Relaxation, ADrainedStrainEndsWithoutPressure) {
  for (const auto& core : {maxwell(RelaxingLoad::strain), several(RelaxingLoad::strain)}) {
    EXPECT_NEAR(pressure_at(core, 1.0, 0.0), 1.0, 1e-10);
    EXPECT_NEAR(pressure_at(core, 1.0, 1e7), 0.0, 1e-10);
  }
}

// What flowed in is the integral of P: d(water)/dt = -K curvature P.
TEST(Relaxation, GrowthIsWhatFlowsIn) {
  for (const RelaxingLoad load :
       {RelaxingLoad::strain, RelaxingLoad::pressure, RelaxingLoad::water}) {
    for (const auto& core : {maxwell(load), several(load)}) {
      const double diffusion = 0.7, share = core.storage / (1 + core.storage);
      const StepResponse response = step_response(core, diffusion);
      for (const double time : {1e-3, 0.3, 5.0, 100.0}) {
        double passed = 0;
        for (std::size_t j = 0; j < response.rate.size(); ++j) {
          passed -= response.pressure[j] * std::expm1(-response.rate[j] * time) / response.rate[j];
        }
        const double growth =
            (pressure_at(core, diffusion, time) - undrained_at(core, diffusion, time)) / share;
        EXPECT_NEAR(growth, -diffusion / share * passed, 1e-9) << time;
      }
    }
  }
}

TEST(Relaxation, ASmallShareIsHardlyDifferentFromNone) {
  Relaxation core = several(RelaxingLoad::strain);
  core.lost.assign(4, 1e-9);
  for (const double time : {0.0, 0.5, 2.0}) {
    EXPECT_NEAR(pressure_at(core, 1.0, time), std::exp(-time), 1e-7);
  }
}

TEST(Relaxation, KeepsTheWaterBetweenSealedWalls) {
  PorePressure water({1, 1}, {1.0, 1.0}, wall_clustered_nodes(1.0, 6), {sealed_wall, sealed_wall},
                     1.0, 0.0, several(RelaxingLoad::strain));
  std::vector<double> load, pressure, undrained;
  for (const double z : water.nodes()) {
    load.push_back(z * z);
  }
  PressureState begin, end;
  water.start(load, begin);
  for (int i = 0; i < 100; ++i) {
    water.step(begin, 0.05, load, end);
    begin = end;
  }
  water.pressure(end, pressure);
  water.undrained(end, undrained);
  const auto lengths = node_lengths(water.nodes());
  double kept = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    kept += lengths[i] * (pressure[i] - undrained[i]);
  }
  EXPECT_NEAR(kept, 0, 1e-12);
}

TEST(Relaxation, AStepMayBeTakenInParts) {
  PorePressure water({1, 1}, {1.0, 1.0}, wall_clustered_nodes(1.0, 4), {open_wall, sealed_wall},
                     1.0, 0.0, several(RelaxingLoad::pressure));
  const std::vector<double> load(water.nodes().size(), 1.0);
  PressureState begin, whole, part, end;
  water.start(load, begin);
  water.step(begin, 0.5, load, whole);
  water.step(begin, 0.2, load, part);
  water.step(part, 0.3, load, end);
  std::vector<double> one, other;
  water.pressure(whole, one);
  water.pressure(end, other);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_NEAR(one[i], other[i], 1e-13);
  }
}

} // namespace
} // namespace ionskin::poroelasticity
