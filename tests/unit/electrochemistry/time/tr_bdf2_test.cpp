// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/time/tr_bdf2.hpp"

#include <gtest/gtest.h>

namespace ionskin::electrochemistry::tr_bdf2 {
namespace {

/// Sum of the weights of begin, middle and end times a power of their instants.
double moment(double begin, double middle, double end, int power) {
  return power == 0   ? begin + middle + end
         : power == 1 ? stage_fraction * middle + end
                      : stage_fraction * stage_fraction * middle + end;
}

TEST(TrBdf2, IsOfSecondOrder) {
  EXPECT_NEAR(moment(weight, weight, diagonal, 0), 1.0, 1e-15);
  EXPECT_NEAR(moment(weight, weight, diagonal, 1), 0.5, 1e-15);
  EXPECT_GT(moment(weight, weight, diagonal, 2), 1.0 / 3.0 + 0.01);
}

TEST(TrBdf2, TheErrorIsMeasuredByAFormulaOfThirdOrder) {
  const double begin = weight - error_of_begin, middle = weight - error_of_middle,
               end = diagonal - error_of_end;
  EXPECT_NEAR(moment(begin, middle, end, 0), 1.0, 1e-15);
  EXPECT_NEAR(moment(begin, middle, end, 1), 0.5, 1e-15);
  EXPECT_NEAR(moment(begin, middle, end, 2), 1.0 / 3.0, 1e-15);
}

} // namespace
} // namespace ionskin::electrochemistry::tr_bdf2
