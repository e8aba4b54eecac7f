// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/system/interrupt.hpp"

#include "ionskin/base/error.hpp"

#include <gtest/gtest.h>

#include <csignal>

namespace ionskin::base {
namespace {

TEST(Interrupt, ScopeForgetsItsRequestAndGivesTheSignalBack) {
  std::signal(SIGINT, SIG_IGN);
  {
    const InterruptScope scope(true);
    std::raise(SIGINT);
    EXPECT_THROW(check_interrupt(), Interrupted);
  }
  EXPECT_NO_THROW(check_interrupt());
  EXPECT_EQ(std::signal(SIGINT, SIG_DFL), SIG_IGN);
  {
    const InterruptScope scope(false);
    request_interrupt();
    EXPECT_TRUE(interrupt_requested());
  }
  EXPECT_FALSE(interrupt_requested());
}

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
