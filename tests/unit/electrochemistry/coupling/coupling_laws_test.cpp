// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/schema/schema.hpp"
#include "ionskin/electrochemistry/coupling/column_neutral.hpp"
#include "ionskin/electrochemistry/coupling/coupling_law.hpp"
#include "ionskin/electrochemistry/coupling/fixed_charge.hpp"
#include "ionskin/electrochemistry/coupling/pair_generation.hpp"
#include "ionskin/electrochemistry/coupling/volume_neutral.hpp"

#include "small_grid.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace ionskin::electrochemistry {
namespace {

class CouplingLaws : public testing::Test {
protected:
  CouplingLaws() : shear(grid.nodes()), ratio(grid.nodes()) {
    for (std::size_t i = 0; i < shear.size(); ++i) {
      shear[i] = 1e-3 * static_cast<double>((i * 7) % 31);
    }
  }

  /// Mean of cf / c0 - 1 over the core, or over one column.
  double mean_excess(std::size_t first_column, std::size_t last_column) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < grid.levels; ++k) {
      for (std::size_t i = first_column; i < last_column; ++i) {
        sum += grid.height[k] * (ratio[k * grid.columns() + i] - 1.0);
      }
    }
    return sum / (grid.thickness * static_cast<double>(last_column - first_column));
  }

  ScaledGrid grid = test::small_grid();
  std::vector<double> shear, ratio;
};

TEST_F(CouplingLaws, EveryNameOfTheSchemaHasOneAndItsFlagIsTrue) {
  for (const Choice& choice : find_row("coupling.law")->choices) {
    const CouplingLaw& law = coupling_law(choice.name);
    EXPECT_EQ(law.apply == nullptr, law.moves_water) << choice.name;
    if (law.moves_water) {
      continue; // shear leaves its fixed charge as it is
    }
    law.apply(0.1, grid, shear, ratio);
    const bool charged = std::abs(mean_excess(0, grid.columns())) > 1e-9;
    EXPECT_EQ(law.makes_net_charge || law.releases_ions, charged) << choice.name;
  }
}

TEST_F(CouplingLaws, FixedChargeIsLocal) {
  apply_fixed_charge(0.1, shear, ratio);
  EXPECT_DOUBLE_EQ(ratio[5], 1.0 + 0.1 * shear[5]);
  EXPECT_GT(mean_excess(0, grid.columns()), 1e-4);
}

TEST_F(CouplingLaws, PairGenerationIsLocalToo) {
  apply_pair_generation(-0.3, shear, ratio);
  EXPECT_DOUBLE_EQ(ratio[5], 1.0 - 0.3 * shear[5]);
}

TEST_F(CouplingLaws, VolumeNeutralConservesTheTotalOnly) {
  apply_volume_neutral(0.1, grid, shear, ratio);
  EXPECT_NEAR(mean_excess(0, grid.columns()), 0.0, 1e-16);
  EXPECT_GT(std::abs(mean_excess(0, 1)), 1e-6);
  EXPECT_NEAR(ratio[7] - ratio[3], 0.1 * (shear[7] - shear[3]), 1e-15);
}

TEST_F(CouplingLaws, ColumnNeutralConservesEveryColumn) {
  apply_column_neutral(-0.2, grid, shear, ratio);
  for (std::size_t i = 0; i < grid.columns(); ++i) {
    EXPECT_NEAR(mean_excess(i, i + 1), 0.0, 1e-16);
  }
  const std::size_t above = 2 * grid.columns() + 4;
  EXPECT_NEAR(ratio[above] - ratio[4], -0.2 * (shear[above] - shear[4]), 1e-15);
}

} // namespace
} // namespace ionskin::electrochemistry
