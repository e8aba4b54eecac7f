// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/impedance/impedance_spectrum.hpp"

#include "ionskin/base/error.hpp"
#include "synthetic_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::study {
namespace {

TEST(ImpedanceSpectrum, FrequenciesMeetBothEnds) {
  const auto two_decades = frequencies({0.1, 10, 2});
  ASSERT_EQ(two_decades.size(), 5u);
  EXPECT_DOUBLE_EQ(two_decades[0], 0.1);
  EXPECT_NEAR(two_decades[2], 1, 1e-15);
  EXPECT_EQ(two_decades[4], 10);
  const auto uneven = frequencies({1, 3, 10});
  EXPECT_EQ(uneven.size(), 6u);
  EXPECT_EQ(uneven.back(), 3);
}

TEST(ImpedanceSpectrum, RefusesAnEmptyRange) {
  EXPECT_THROW(frequencies({1, 1, 10}), UserError);
  EXPECT_THROW(frequencies({0, 1, 10}), UserError);
  EXPECT_THROW(frequencies({-1, 1, 10}), UserError);
  EXPECT_THROW(frequencies({1e-300, 1e300, 1000}), UserError);
}

TEST(ImpedanceSpectrum, ColumnsAgreeWithEachOther) {
  Case input = handover::small_case();
  input.electrochemistry = {293.15, 7e-11, 2e-3, 1200, 1};
  const auto table = impedance_spectrum(input, {0.1, 10});
  const double area = input.skin.length * input.skin.width;
  for (std::size_t row = 0; row < 2; ++row) {
    const auto at = [&](const char* name) { return table.column(name).values[row]; };
    EXPECT_NEAR(at("area_impedance_real"), area * at("impedance_real"), 1e-12);
    EXPECT_NEAR(at("area_impedance_imaginary"), area * at("impedance_imaginary"), 1e-12);
    EXPECT_NEAR(at("magnitude"), std::hypot(at("impedance_real"), at("impedance_imaginary")), 1e-9);
    EXPECT_LT(at("phase_angle"), 0);
    EXPECT_GT(at("phase_angle"), -90);
  }
}

} // namespace
} // namespace ionskin::study
