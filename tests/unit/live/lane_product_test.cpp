// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/products/lane_product.hpp"
#include "ionskin/live/products/low_rank.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ionskin::live {
namespace {

constexpr std::size_t product_rows = 61, product_columns = 17; // no multiples of what goes at once

class LaneProducts : public testing::Test {
protected:
  LaneProducts() {
    for (std::size_t row = 0; row < product_rows; ++row) {
      for (std::size_t column = 0; column < product_columns; ++column) {
        product.at(row, column) = number();
      }
    }
  }
  float number() { return std::uniform_real_distribution<float>(-1, 1)(random); }

  std::mt19937 random{1};
  LaneProduct product{product_rows, product_columns};
  std::vector<std::uint32_t> counted{0, 3, 4, 11, 16};
};

TEST_F(LaneProducts, TakesTheColumnsThatCount) {
  std::vector<float> factors(counted.size()), result(product.stride());
  for (float& factor : factors) {
    factor = number();
  }
  product.times(1, counted, factors.data(), result.data());
  for (std::size_t row = 0; row < product_rows; ++row) {
    double sum = 0;
    for (std::size_t i = 0; i < counted.size(); ++i) {
      sum += static_cast<double>(factors[i]) * static_cast<double>(product.at(row, counted[i]));
    }
    EXPECT_NEAR(static_cast<double>(result[row]), sum, 1e-6) << row;
  }
}

TEST_F(LaneProducts, OneLaneDoesNotFeelTheOthers) {
  std::vector<float> alone(counted.size()), together(most_lanes * counted.size()),
      own(product.stride()), all(most_lanes * product.stride());
  for (std::size_t lane = 0; lane < most_lanes; ++lane) {
    for (std::size_t i = 0; i < counted.size(); ++i) {
      for (std::size_t other = 0; other < most_lanes; ++other) {
        together[i * most_lanes + other] = number();
      }
      alone[i] = together[i * most_lanes + lane];
    }
    product.times(1, counted, alone.data(), own.data());
    product.times(most_lanes, counted, together.data(), all.data());
    for (std::size_t row = 0; row < product_rows; ++row) {
      EXPECT_EQ(all[lane * product.stride() + row], own[row]) << lane << " " << row;
    }
  }
}

TEST_F(LaneProducts, FewCrossesGiveASmoothMatrix) {
  std::vector<double> smooth(product_rows * product_columns), rough(product_rows * product_columns);
  for (std::size_t i = 0; i < smooth.size(); ++i) {
    const double row = static_cast<double>(i % product_rows),
                 column = static_cast<double>(i / product_rows);
    smooth[i] = std::sin(0.1 * (row + column)); // two products
    rough[i] = static_cast<double>(number());
  }
  for (const auto& [matrix, least, most] :
       {std::tuple{smooth, 2u, 2u}, {rough, static_cast<unsigned>(product_columns), 61u}}) {
    const LowRank products = low_rank(matrix, product_rows, 1e-6);
    EXPECT_GE(products.rank, least);
    EXPECT_LE(products.rank, most);
    for (std::size_t i = 0; i < matrix.size(); ++i) {
      double sum = 0;
      for (std::size_t q = 0; q < products.rank; ++q) {
        sum += static_cast<double>(products.columns[q * product_rows + i % product_rows]) *
               static_cast<double>(products.rows[q * product_columns + i / product_rows]);
      }
      ASSERT_NEAR(sum, matrix[i], 3e-6) << i;
    }
  }
  EXPECT_EQ(low_rank({}, product_rows, 1e-6).rank, 0u);
}

} // namespace
} // namespace ionskin::live
