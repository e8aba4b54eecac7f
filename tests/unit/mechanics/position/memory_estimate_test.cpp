// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/memory_estimate.hpp"

#include "ionskin/mechanics/position/skin_model.hpp"
#include "small_case.hpp"

#include <gtest/gtest.h>

namespace ionskin::mechanics {
namespace {

TEST(MemoryEstimate, follows_the_power_of_the_unknowns_in_docs_clusters) {
  EXPECT_DOUBLE_EQ(factorisation_memory(100000), 0.94e9);
  EXPECT_NEAR(factorisation_memory(114000), 1.107e9, 1e6);
  EXPECT_NEAR(factorisation_memory(45000), 0.346e9, 1e6);
}

TEST(MemoryEstimate, is_about_that_of_the_factors_of_a_skin) {
  Case input = small_case();
  input.numerics.mesh_refinement = 1.0;
  const SkinModel model(input, mesh::largest_footprint(input));
  const SkinParts& parts = model.analysis().parts;
  double factors = 8 * parts.inner.part->symbolic.factor_entries();
  for (const PlacedPart& placed : parts.outer) {
    factors += 8 * placed.part->symbolic.factor_entries();
  }
  const double estimate = factorisation_memory(model.mesh.unknowns());
  EXPECT_GT(estimate, factors); // what is condensed takes about as much
  EXPECT_LT(estimate, 4 * factors);
}

TEST(MemoryEstimate, is_of_as_many_factors_as_fit_together_but_one_at_least) {
  EXPECT_DOUBLE_EQ(factorisations_memory(600000, 8), factorisation_memory(600000));
  EXPECT_DOUBLE_EQ(factorisations_memory(100000, 8), 4 * 0.94e9); // 0.56 of each within 2.4 GB
  EXPECT_DOUBLE_EQ(factorisations_memory(100000, 3), 3 * 0.94e9);
  EXPECT_DOUBLE_EQ(factorisations_memory(20000, 2), 2 * factorisation_memory(20000));
}

} // namespace
} // namespace ionskin::mechanics
