// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/point_failure.hpp"

#include "ionskin/base/error.hpp"

#include <gtest/gtest.h>

#include <new>

namespace ionskin::study {
namespace {

TEST(PointFailure, EveryFailureHasItsReasonAndAnInterruptionPasses) {
  EXPECT_EQ(failure_of([] {}), std::nullopt);
  EXPECT_EQ(failure_of([] { throw SolverError("no contact", "press harder"); }),
            "no contact; remedy: press harder");
  EXPECT_EQ(failure_of([] { throw UserError("off the skin"); }), "off the skin");
  EXPECT_EQ(failure_of([] { throw std::bad_alloc(); })->substr(0, 13), "out of memory");
  EXPECT_THROW(failure_of([] { throw Interrupted(); }), Interrupted);
}

} // namespace
} // namespace ionskin::study
