// SPDX-License-Identifier: Apache-2.0
#include "ionskin/poroelasticity/prescribed_load.hpp"

#include <gtest/gtest.h>

namespace ionskin::poroelasticity {
namespace {

/// Shear modulus 80 MPa, undrained Poisson's ratio all but 0.5, drained 0.4: M = 480 MPa.
Case pressed() {
  Case input;
  input.skin.length = 0.03;
  input.skin.width = 5e-3;
  input.skin.layers = {{"bottom", LayerRole::electrode, {}, 1e-5},
                       {"core", LayerRole::core, {"polymer", 240e6, 0.4999999}, 200e-6},
                       {"top", LayerRole::electrode, {}, 1e-5}};
  input.water.drained_modulus = 480e6;
  input.strain.kind = StrainSourceKind::prescribed;
  input.strain.pressure = 1e5;
  input.strain.duration = 2;
  return input;
}

double at(const history::CoreHistory& history, std::size_t sample, std::size_t node) {
  return (*history.channel(history::channel_name::undrained_pressure).samples[sample])[node];
}

TEST(PrescribedLoad, PressureIsThatOfTheWater) {
  const auto history = prescribed_history(pressed());
  EXPECT_EQ(history.time, (std::vector{0.0, 2.0}));
  EXPECT_EQ(history.grid.values(), 2u);
  EXPECT_EQ(history.core_thickness(), 200e-6);
  EXPECT_NEAR(at(history, 0, 0), 1e5, 1);
  EXPECT_NEAR(at(history, 1, 1), 1e5, 1);
}

TEST(PrescribedLoad, BendingPressesOneFaceAndStretchesTheOther) {
  Case input = pressed();
  input.strain.pressure = 0;
  input.strain.curvature = 10; // e_xx = 1e-3 at the faces
  EXPECT_NEAR(at(prescribed_history(input), 0, 1), -80e6 * 1e-3, 10);
  EXPECT_NEAR(at(prescribed_history(input), 0, 0), 80e6 * 1e-3, 10);
  input.skin.sides = SideCondition::symmetry;
  EXPECT_NEAR(at(prescribed_history(input), 0, 0), 160e6 * 1e-3, 20);
}

TEST(PrescribedLoad, RampIsHeldAndSineSwings) {
  Case input = pressed();
  input.strain.waveform = LoadWaveform::ramp;
  input.strain.rise = 0.5;
  const auto ramp = prescribed_history(input);
  EXPECT_EQ(ramp.time, (std::vector{0.0, 0.5, 2.0}));
  EXPECT_EQ(ramp.event_time, (std::vector{0.0, 0.5}));
  EXPECT_EQ(at(ramp, 0, 0), 0.0);
  EXPECT_EQ(at(ramp, 1, 0), at(ramp, 2, 0));
  input.strain.rise = 2;
  EXPECT_EQ(prescribed_history(input).time, (std::vector{0.0, 2.0}));
  input.strain.waveform = LoadWaveform::sine;
  input.strain.frequency = 1;
  const auto sine = prescribed_history(input);
  ASSERT_EQ(sine.time.size(), 129u);
  EXPECT_EQ(sine.time.back(), 2.0);
  EXPECT_NEAR(at(sine, 16, 0), 1e5, 1);
  EXPECT_NEAR(at(sine, 48, 0), -1e5, 1);
}

} // namespace
} // namespace ionskin::poroelasticity
