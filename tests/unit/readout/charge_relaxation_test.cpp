// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/charge_relaxation.hpp"

#include <gtest/gtest.h>

namespace ionskin::readout {
namespace {

double cubic(double t) {
  return 1 + t * (2 + t * (-3 + 0.5 * t));
}
double slope(double t) {
  return 2 + t * (-6 + 1.5 * t);
}

TEST(ChargeRelaxation, FollowsACubicBetweenTheRows) {
  const std::vector<double> time{0, 0.5, 2};
  ChargeRelaxation relaxation;
  for (const double t : time) {
    relaxation.charge.push_back(cubic(t));
    relaxation.current.push_back(slope(t));
  }
  for (const double t : {0.1, 0.45, 0.5, 1.0, 1.9}) {
    const std::size_t i = t < 0.5 ? 1 : 2;
    const double weight = (t - time[i - 1]) / (time[i] - time[i - 1]);
    const double line = (1 - weight) * relaxation.charge[i - 1] + weight * relaxation.charge[i];
    EXPECT_NEAR(line + departure_from_line(time, relaxation, t), cubic(t), 1e-14) << t;
  }
}

TEST(ChargeRelaxation, IsNothingOnTheRowsOutsideThemAndWhereUnknown) {
  const ChargeRelaxation relaxation{{0, 1}, {5, 7}};
  for (const double t : {-1.0, 0.0, 1.0, 2.0}) {
    EXPECT_EQ(departure_from_line({0, 1}, relaxation, t), 0) << t;
  }
  EXPECT_EQ(departure_from_line({0, 1}, {}, 0.5), 0);
}

} // namespace
} // namespace ionskin::readout
