// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/contact/normal_correction.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace ionskin::live {
namespace {

/// Compliance that falls with distance; friction makes it other to the right than to the left.
float compliance(std::size_t row, std::size_t column) {
  const double distance = static_cast<double>(row) - static_cast<double>(column);
  return static_cast<float>(1 / (1 + distance * distance) + 0.1 * distance / 30);
}

TEST(NormalCorrection, SolvesForTheCellsThatTouch) {
  constexpr std::size_t cells = 30;
  NormalCorrection correction(cells);
  for (const std::vector<std::size_t>& touching :
       {std::vector<std::size_t>{0, 1, 2, 5, 6, 7, 11, 17, 29}, std::vector<std::size_t>{4}}) {
    EXPECT_FALSE(correction.is_of(touching));
    correction.take(touching);
    std::vector<float> values(touching.size());
    for (std::size_t j = 0; j < touching.size(); ++j) {
      for (std::size_t i = 0; i < touching.size(); ++i) {
        correction.column(j)[i] = compliance(touching[i], touching[j]);
        values[i] += static_cast<float>(j + 1) * compliance(touching[i], touching[j]);
      }
    }
    ASSERT_TRUE(correction.factor());
    EXPECT_TRUE(correction.is_of(touching));
    correction.solve(values);
    for (std::size_t j = 0; j < touching.size(); ++j) {
      EXPECT_NEAR(values[j], static_cast<float>(j + 1), 1e-5f);
    }
  }
  correction.forget();
  EXPECT_FALSE(correction.is_of(std::array<std::size_t, 1>{4}));
}

TEST(NormalCorrection, RefusesWhatIsNoCompliance) {
  NormalCorrection correction(2);
  const std::array<std::size_t, 2> touching{0, 1};
  correction.take(touching);
  correction.column(0)[0] = correction.column(0)[1] = 1;
  correction.column(1)[0] = correction.column(1)[1] = 1;
  EXPECT_FALSE(correction.factor());
  EXPECT_FALSE(correction.is_of(touching));
}

} // namespace
} // namespace ionskin::live
