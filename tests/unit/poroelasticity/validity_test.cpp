// SPDX-License-Identifier: Apache-2.0
#include "ionskin/poroelasticity/validity.hpp"

#include <gtest/gtest.h>

namespace ionskin::poroelasticity {
namespace {

/// Held for 2 s and for the part of touchdown and lift in contact; water as permeation measures it.
Case touched() {
  Case input;
  input.skin.layers = {{"bottom", LayerRole::electrode, {}, 1e-5},
                       {"core", LayerRole::core, {"polymer", 249e6, 0.49}, 180e-6},
                       {"top", LayerRole::electrode, {}, 1e-5}};
  input.slider.size = {3e-3, 1.5e-3};
  input.slider.start = {4.5e-3, 1e-3};
  input.motion.gap = 1e-3;
  input.motion.preload = 1e-6;
  input.motion.stroke = 6e-3;
  input.motion.touchdown = input.motion.lift = 0.5;
  input.motion.slide = 2;
  input.motion.return_ = 1;
  input.electrochemistry.temperature = 293.15;
  input.electrochemistry.fixed_charge_concentration = 1200;
  input.water.drag_number = 2.5;
  input.water.drained_poissons_ratio = 0.4;
  input.water.consolidation_coefficient = 5e-9;
  return input;
}

TEST(Validity, AHeldIndentationIsWarnedOfAndAForceIsNot) {
  Case input = touched();
  EXPECT_NEAR(holding(input).time, 2.001, 1e-3);
  EXPECT_NEAR(holding(input).number, 5e-9 * 2.001 / 3.24e-8, 1e-3);
  ASSERT_EQ(validity_warnings(input).size(), 1u);
  const std::string warning = validity_warnings(input).front();
  for (const char* words : {"c_v t/h^2 = 0.309", "the load relaxes", "motion.preload = "}) {
    EXPECT_NE(warning.find(words), std::string::npos) << warning;
  }
  input.motion.preload = 0;
  input.motion.preload_force = 10;
  EXPECT_TRUE(holding(input).by_force);
  EXPECT_TRUE(validity_warnings(input).empty());
}

TEST(Validity, AShortTouchIsSound) {
  Case input = touched();
  input.motion.slide = 0.1;
  EXPECT_TRUE(validity_warnings(input).empty());
}

TEST(Validity, WaterSlowerThanItsSelfDiffusionIsWarnedOf) {
  Case input = touched();
  input.water.consolidation_coefficient = 0;
  input.water.mobility = 2e-19;
  ASSERT_EQ(validity_warnings(input).size(), 1u);
  const std::string warning = validity_warnings(input).front();
  for (const char* words : {"2e-19 m2/(Pa s) is below 1.5e-18", "Sorption", "permeation"}) {
    EXPECT_NE(warning.find(words), std::string::npos) << warning;
  }
  input.water.mobility = 5e-18;
  input.motion.slide = 0.1;
  EXPECT_TRUE(validity_warnings(input).empty());
  input.water.mobility = 2e-19;
  input.skin.humidity = 0.5; // in air it is slower
  EXPECT_TRUE(validity_warnings(input).empty());
}

TEST(Validity, DecouplingErrsByTheTable) {
  Case input = touched();
  input.motion.slide = 0.1 * 3.24e-8 / 5e-9 - 1e-3; // c_v t/h2 = 0.1
  EXPECT_NEAR(decoupling_error(input), 0.46, 5e-3);
  input.water.consolidation_coefficient = 5e-11; // 0.001
  EXPECT_NEAR(decoupling_error(input), 0.007, 1e-4);
  input.motion.preload = 0;
  input.motion.preload_force = 10;
  input.water.consolidation_coefficient = 5e-9;
  EXPECT_GT(decoupling_error(input), 0.2);
  EXPECT_LT(decoupling_error(input), 0.35);
  input.strain.kind = StrainSourceKind::prescribed;
  EXPECT_EQ(decoupling_error(input), 0);
  EXPECT_EQ(holding(input).time, 0);
}

} // namespace
} // namespace ionskin::poroelasticity
