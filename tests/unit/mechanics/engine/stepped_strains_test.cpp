// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/stepped_strains.hpp"

#include "small_line.hpp"

#include <gtest/gtest.h>

namespace ionskin::mechanics {
namespace {

constexpr std::size_t states = 20; // of more than one block

CellVector force_at(std::size_t state) {
  CellVector force(3 * line().model->cells.count(), 0.0);
  for (std::size_t i = 0; i < force.size(); i += 3) {
    force[i] = 1 + static_cast<double>(state * i) / static_cast<double>(force.size());
    force[i + 1] = 0.3 * force[i];
  }
  return force;
}

std::array<double, 2> place_at(std::size_t state) {
  return {1.5e-3 + 1e-4 * static_cast<double>(state), 1e-3};
}

TEST(SteppedStrains, AreThoseOfEachStateByItselfInAnyOrder) {
  const auto recovery =
      std::make_shared<const StrainRecovery>(line().model, finite_layers::all_components);
  SteppedStrains path(recovery, 2);
  for (std::size_t k = 0; k < states; ++k) {
    EXPECT_EQ(path.add(place_at(k), force_at(k)), k);
  }
  for (const std::size_t k : {std::size_t{0}, states - 1, std::size_t{7}}) {
    const std::array<std::array<double, 2>, 1> place{place_at(k)};
    const std::array<CellVector, 1> force{force_at(k)};
    const RecoveredStrain alone = recovery->at(place, force).front();
    EXPECT_EQ(path.at(k).component, alone.core.component) << k;
    ASSERT_EQ(path.largest_electrode_stress().size(), 2u);
    EXPECT_GE(path.largest_electrode_stress()[0], alone.electrode_stress[0]);
  }
  EXPECT_LT(path.worst_equilibrium_residual(), 1e-3);
}

} // namespace
} // namespace ionskin::mechanics
