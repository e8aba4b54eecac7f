// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/metrics/audits.hpp"

#include "ionskin/base/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <string>

namespace ionskin::study {
namespace {

std::vector<Audit> audit_of(double residual) {
  return audit({{"normal_force_slide", 3, "N"}, {"equilibrium_residual", residual, "1"}});
}

TEST(Audits, PassWarnAndFail) {
  EXPECT_EQ(audit_of(1e-12).size(), 1u);
  EXPECT_EQ(audit_of(1e-12).front().verdict, Verdict::passed);
  EXPECT_EQ(audit_of(1e-2).front().verdict, Verdict::warned);
  EXPECT_EQ(audit_of(0.33).front().verdict, Verdict::failed);
  EXPECT_EQ(audit_of(std::numeric_limits<double>::quiet_NaN()).front().verdict, Verdict::failed);
}

TEST(Audits, SayValueLimitAndRemedy) {
  EXPECT_TRUE(audit_warnings(audit_of(1e-12)).empty());
  const auto warnings = audit_warnings(audit_of(0.33));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings.front(), testing::HasSubstr("FAILED AUDIT"));
  EXPECT_THAT(warnings.front(), testing::HasSubstr("0.33"));
  EXPECT_NO_THROW(require_sound(audit_of(1e-2), "out"));
  EXPECT_THROW(require_sound(audit_of(0.33), "out"), SolverError);
}

TEST(Audits, EveryQuantityWarnsBeforeItFails) {
  const auto verdict = [](const AuditRule& rule, double value) {
    return audit({{rule.metric, value, "1"}}).front().verdict;
  };
  for (const AuditRule& rule : audit_rules()) {
    EXPECT_EQ(verdict(rule, 0.99 * rule.warn), Verdict::passed) << rule.metric;
    EXPECT_EQ(verdict(rule, 1.01 * rule.warn), Verdict::warned) << rule.metric;
    EXPECT_EQ(verdict(rule, 0.99 * rule.fail), Verdict::warned) << rule.metric;
    EXPECT_EQ(verdict(rule, 1.01 * rule.fail), Verdict::failed) << rule.metric;
  }
}

// Energy 0.33 off, energy of 0.86 of the work from nothing, charges 0.99 and a shear of 3.7 once
// ended with exit 0.
TEST(Audits, NothingFarFromSoundPasses) {
  for (const auto& [name, value] : std::map<std::string, double>{{"energy_balance_error", 0.33},
                                                                 {"energy_creation_error", 0.86},
                                                                 {"charge_identity_error", 0.99},
                                                                 {"largest_p99_shear", 3.7}}) {
    EXPECT_EQ(audit({{name, value, "1"}}).front().verdict, Verdict::failed) << name;
  }
}

} // namespace
} // namespace ionskin::study
