// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/interrupt.hpp"

#include "ionskin/base/error.hpp"

#include <gtest/gtest.h>

#include <csignal>

namespace ionskin::base {
namespace {

TEST(Interrupt, SignalBecomesAnExceptionAtTheNextCheck) {
  install_interrupt_handler();
  EXPECT_FALSE(interrupt_requested());
  EXPECT_NO_THROW(check_interrupt());
  std::raise(SIGTERM);
  EXPECT_TRUE(interrupt_requested());
  EXPECT_THROW(check_interrupt(), Interrupted);
}

} // namespace
} // namespace ionskin::base
