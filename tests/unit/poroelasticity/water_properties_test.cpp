// SPDX-License-Identifier: Apache-2.0
#include "ionskin/poroelasticity/water_properties.hpp"

#include "ionskin/case/elastic_constants.hpp"

#include <gtest/gtest.h>

namespace ionskin::poroelasticity {
namespace {

Case wet_case() {
  Case input;
  input.skin.layers = {{"bottom", LayerRole::electrode, {"metal", 1e11, 0.3}, 1e-5},
                       {"core", LayerRole::core, {"polymer", 249e6, 0.49}, 180e-6},
                       {"top", LayerRole::electrode, {"metal", 1e11, 0.3}, 1e-5}};
  input.electrochemistry.temperature = 293.15;
  input.electrochemistry.fixed_charge_concentration = 1200;
  input.water.drag_number = 2.5;
  input.water.drained_modulus = 3.9e8;
  input.water.mobility = 2e-19;
  return input;
}

TEST(WaterProperties, AreThoseOfTheReference) {
  const WaterProperties water = derive_water_properties(wet_case());
  EXPECT_NEAR(water.streaming_coefficient, 4.6818e-10, 1e-14);
  EXPECT_NEAR(water.thermal_voltage, 0.0252617, 1e-7);
  EXPECT_NEAR(water.streaming_number(), 7.22794, 1e-4);
  // L_s is half as large for twice the valence, and S does not change.
  Case divalent = wet_case();
  divalent.electrochemistry.valence = 2;
  EXPECT_NEAR(derive_water_properties(divalent).streaming_number(), 7.22794, 1e-4);
  EXPECT_NEAR(water.consolidation_coefficient, 2e-19 / (1 / 3.9e8 + 1 / water.storage_modulus),
              1e-20);
  EXPECT_NEAR(water.skempton_coefficient, 1 - (3.9e8 - 4.0 / 3 * 249e6 / 2.98) / (249e6 / 0.06),
              1e-12);
}

TEST(WaterProperties, FollowFromAnyOfTheirKeys) {
  Case input = wet_case();
  const WaterProperties first = derive_water_properties(input);
  input.water.mobility = 0;
  input.water.permeability = 2e-19 * 0.89e-3;
  input.water.viscosity = 0.89e-3;
  EXPECT_NEAR(derive_water_properties(input).mobility, 2e-19, 1e-32);
  input.water.permeability = 0;
  input.water.consolidation_coefficient = first.consolidation_coefficient;
  EXPECT_NEAR(derive_water_properties(input).mobility, 2e-19, 1e-32);
  input.water.drained_modulus = 0;
  input.water.drained_poissons_ratio = 0.4;
  EXPECT_NEAR(derive_water_properties(input).drained_modulus,
              2 * shear_modulus(input.skin.layers[1].material) * 0.6 / 0.2, 1);
  input.water.dilution = WaterDilution::pore_water;
  input.water.volume_fraction = 0.4;
  EXPECT_NEAR(derive_water_properties(input).dilution, 2.5, 1e-12);
}

} // namespace
} // namespace ionskin::poroelasticity
