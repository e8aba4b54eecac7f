// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/return_mapping.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace ionskin::laws {
namespace {

Friction of(const char* law, const LawValues& values) {
  return friction(law, 0.3, values);
}

/// Under the pressure of the step before, where friction remembers one.
const FrictionTrial trial{1e6, {5e5, 2e5}, 2e-13, 1e-3, 0, {{}, 3e5}};

TEST(ReturnMapping, StickingCarriesTheTrial) {
  FrictionTrial small = trial;
  small.traction = {1e5, -2e5};
  const FrictionResponse response = return_mapping(of("coulomb", {}), small);
  EXPECT_TRUE(response.sticks);
  EXPECT_EQ(response.traction, small.traction);
  EXPECT_EQ(response.by_trial[0][0], 1);
  EXPECT_EQ(response.by_trial[0][1], 0);
}

TEST(ReturnMapping, CoulombShortensButDoesNotTurn) {
  const auto t = return_mapping(of("coulomb", {}), trial).traction;
  EXPECT_NEAR(std::hypot(t[0], t[1]), 3e5, 1e-9);
  EXPECT_NEAR(t[0] * 2 - t[1] * 5, 0, 1e-6);
  FrictionTrial inside = trial;
  inside.traction = {1e5, 0};
  EXPECT_NEAR(return_mapping(of("coulomb", {}), inside, true).traction[0], 3e5, 1e-9);
}

TEST(ReturnMapping, TractionIsTheLimitOfItsOwnSlip) {
  for (const auto& [law, values] : {std::pair{"viscous", LawValues{{"reference_speed", 1e-4}}},
                                    std::pair{"regularised", LawValues{{"slip_length", 1e-7}}},
                                    std::pair{"regularised", LawValues{{"slip_length", 1e-8}}}}) {
    const Friction friction = of(law, values);
    const FrictionResponse response = return_mapping(friction, trial);
    const double length = std::hypot(response.traction[0], response.traction[1]);
    const double slip = trial.compliance * (std::hypot(5e5, 2e5) - length);
    EXPECT_GE(slip, 0);
    EXPECT_NEAR(length, friction.limit({1e6, slip, 1e-3}), 1e-9 * length) << law;
  }
}

/// Work of a traction along the slip that a trial asks for.
double work(const TangentialVector& traction, const TangentialVector& slip) {
  return traction[0] * slip[0] + traction[1] * slip[1];
}

TEST(ReturnMapping, SlipIsNormalToTheEllipse) {
  const Friction friction = of("anisotropic", {{"transverse_friction", 0.1}});
  for (const TangentialVector z : {TangentialVector{5e5, 2e5}, TangentialVector{1e4, -4e5},
                                   TangentialVector{-3e8, 1e3}, TangentialVector{0, 1.001e5}}) {
    FrictionTrial other = trial;
    other.traction = z;
    const auto t = return_mapping(friction, other).traction;
    EXPECT_NEAR(limit_norm(friction, t), 3e5, 1e-7 * 3e5);
    const TangentialVector slip{z[0] - t[0], z[1] - t[1]};
    for (int i = 0; i < 360; ++i) {
      const double angle = i * M_PI / 180;
      const TangentialVector allowed{3e5 * std::cos(angle), 1e5 * std::sin(angle)};
      EXPECT_LE(work(allowed, slip), work(t, slip) + 1e-9 * std::abs(work(t, slip)));
    }
  }
  const auto along = sliding_traction(friction, 3e5, {0.6, 0.8});
  EXPECT_NEAR(limit_norm(friction, along), 3e5, 1e-9);
  EXPECT_NEAR(along[1] / along[0], (0.01 * 0.8) / (0.09 * 0.6), 1e-12);
}

TEST(ReturnMapping, EllipseOfOneCoefficientIsTheDisc) {
  const auto disc = return_mapping(of("coulomb", {}), trial).traction;
  const auto ellipse =
      return_mapping(of("anisotropic", {{"transverse_friction", 0.3 * (1 + 1e-12)}}), trial)
          .traction;
  EXPECT_NEAR(disc[0], ellipse[0], 1e-5);
  EXPECT_NEAR(disc[1], ellipse[1], 1e-5);
}

TEST(ReturnMapping, DerivativesAgreeWithFiniteDifferences) {
  for (const Friction& friction :
       {of("coulomb", {}), of("saturating", {{"strength", 4e5}, {"sharpness", 2}}),
        of("viscous", {{"reference_speed", 1e-4}}), of("regularised", {{"slip_length", 3e-7}}),
        of("stribeck", {{"kinetic_friction", 0.2}, {"stribeck_speed", 1e-3}, {"lag_time", 1e-3}}),
        of("anisotropic", {{"transverse_friction", 0.1}})}) {
    // Under a pressure that rose, fell, or rose from nothing since an elastic slip was made.
    for (const ElasticSlip& elastic :
         {ElasticSlip{{5e-8, -9e-8}, 1e5}, ElasticSlip{{5e-8, -9e-8}, 5e5}, ElasticSlip{{}, 0}}) {
      FrictionTrial at = trial;
      at.elastic = elastic;
      const FrictionResponse response = return_mapping(friction, at);
      constexpr double step = 10; // Pa
      for (std::size_t s = 0; s < 3; ++s) {
        FrictionTrial more = at, less = at;
        (s < 2 ? more.traction[s] : more.normal_traction) += step;
        (s < 2 ? less.traction[s] : less.normal_traction) -= step;
        const auto above = return_mapping(friction, more), below = return_mapping(friction, less);
        for (std::size_t r = 0; r < 2; ++r) {
          const double difference = (above.traction[r] - below.traction[r]) / (2 * step);
          const double found = s < 2 ? response.by_trial[r][s] : response.by_normal[r];
          EXPECT_NEAR(found, difference, 1e-6) << friction.law << r << s;
        }
      }
    }
  }
}

} // namespace
} // namespace ionskin::laws
