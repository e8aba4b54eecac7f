// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/position_key.hpp"

#include "ionskin/mechanics/position/skin_model.hpp"
#include "small_case.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::mechanics {
namespace {

base::Digest key_of(const Case& input) {
  const SkinModel model(input, mesh::largest_footprint(input));
  return position_key(model, model.mesh.lines(input.slider.start));
}

TEST(PositionKey, IsThatOfTheSamePlaceOfAnotherRun) {
  EXPECT_EQ(key_of(small_case()), key_of(small_case()));
  Case rougher = small_case(); // friction is no part of a position
  rougher.contact.friction = 0.1;
  EXPECT_EQ(key_of(rougher), key_of(small_case()));
}

TEST(PositionKey, IsAnotherAtAnotherPlaceOfAnotherMaterialOrHeldOtherwise) {
  const SkinModel model(small_case(), mesh::largest_footprint(small_case()));
  mesh::MeshLines lines = model.mesh.lines(small_case().slider.start);
  const base::Digest key = position_key(model, lines);
  lines.x[1] = std::nextafter(lines.x[1], 0.0);
  EXPECT_NE(position_key(model, lines), key);

  Case softer = small_case(), held = small_case();
  softer.skin.layers.back().material.youngs_modulus *= 0.5;
  held.skin.sides = SideCondition::symmetry;
  EXPECT_NE(key_of(softer), key);
  EXPECT_NE(key_of(held), key);
}

} // namespace
} // namespace ionskin::mechanics
