// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/coupling/coupling_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>
#include <vector>

namespace ionskin::laws {
namespace {

class CouplingLaws : public testing::Test {
protected:
  CouplingLaws() : shear(core.columns * core.levels), ratio(shear.size()) {
    for (std::size_t i = 0; i < shear.size(); ++i) {
      shear[i] = 1e-3 * static_cast<double>((i * 7) % 31);
    }
  }

  /// Mean of cf / c0 - 1 over the core, or over one column.
  double mean_excess(std::size_t first_column, std::size_t last_column) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < core.levels; ++k) {
      for (std::size_t i = first_column; i < last_column; ++i) {
        sum += core.height[k] * (ratio[k * core.columns + i] - 1.0);
      }
    }
    return sum / (core.thickness * static_cast<double>(last_column - first_column));
  }

  void apply(std::string_view law, double coefficient) {
    coupling_law(law).with(coefficient, {})(core, shear, ratio);
  }

  std::vector<double> heights{0.5, 1.5, 2.0, 1.0, 0.25};
  CoreLayout core{12, heights.size(), heights, 5.25};
  std::vector<double> shear, ratio;
};

TEST_F(CouplingLaws, DoWhatTheirTraitsSay) {
  for (const CouplingLaw& law : coupling_laws()) {
    if (!law.parameters.empty()) {
      continue; // its own test knows what values show its traits
    }
    EXPECT_EQ(!law.with(0.1, {}), law.traits.moves_water) << law.name;
    if (law.traits.moves_water) {
      continue; // shear leaves its fixed charge as it is
    }
    apply(law.name, 0.1);
    const double excess = mean_excess(0, core.columns);
    EXPECT_EQ(law.traits.makes_net_charge || law.traits.releases_ions, std::abs(excess) > 1e-9)
        << law.name;
    if (law.traits.net_charge_is_linear) {
      apply(law.name, 0.2);
      EXPECT_NEAR(mean_excess(0, core.columns), 2 * excess, 1e-14) << law.name;
    }
  }
}

TEST_F(CouplingLaws, FixedChargeIsLocal) {
  apply("fixed-charge", 0.1);
  EXPECT_DOUBLE_EQ(ratio[5], 1.0 + 0.1 * shear[5]);
  EXPECT_GT(mean_excess(0, core.columns), 1e-4);
}

TEST_F(CouplingLaws, PairGenerationIsLocalToo) {
  apply("pair-generation", -0.3);
  EXPECT_DOUBLE_EQ(ratio[5], 1.0 - 0.3 * shear[5]);
}

TEST_F(CouplingLaws, VolumeNeutralConservesTheTotalOnly) {
  apply("volume-neutral", 0.1);
  EXPECT_NEAR(mean_excess(0, core.columns), 0.0, 1e-16);
  EXPECT_GT(std::abs(mean_excess(0, 1)), 1e-6);
  EXPECT_NEAR(ratio[7] - ratio[3], 0.1 * (shear[7] - shear[3]), 1e-15);
}

TEST_F(CouplingLaws, ColumnNeutralConservesEveryColumn) {
  apply("column-neutral", -0.2);
  for (std::size_t i = 0; i < core.columns; ++i) {
    EXPECT_NEAR(mean_excess(i, i + 1), 0.0, 1e-16);
  }
  const std::size_t above = 2 * core.columns + 4;
  EXPECT_NEAR(ratio[above] - ratio[4], -0.2 * (shear[above] - shear[4]), 1e-15);
}

} // namespace
} // namespace ionskin::laws
