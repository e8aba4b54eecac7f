// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/metrics/slip_metrics.hpp"

#include "synthetic_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ionskin::study {
namespace {

/// On a slide at 3 mm/s from 0.5 s the stuck share falls from 1 to 0 within 1 ms, the tangential
/// force rises to 0.3 of the normal one.
MechanicsRecord linear_onset() {
  MechanicsRecord record;
  record.history.time = {0, 0.4999, 0.5, 0.501, 2.5, 3, 4};
  record.contact_area = {0, 1e-6, 1e-6, 1e-6, 1e-6, 0, 0};
  record.stick_share = {0, 1, 1, 0, 0, 0, 0};
  record.normal_force = {0, 2, 2, 2, 2, 0, 0};
  record.tangential_force = {0, 0, 0, 0.6, 0.6, 0, 0};
  return record;
}

double value(const std::vector<readout::Metric>& metrics, const std::string& name) {
  const auto found = std::ranges::find(metrics, name, &readout::Metric::name);
  return found == metrics.end() ? std::nan("") : found->value;
}

TEST(SlipMetrics, TellHowTheFirstSlideBegins) {
  const auto metrics = slip_metrics(handover::small_case(), linear_onset());
  EXPECT_NEAR(value(metrics, "micro_slip_time"), 0.05e-3, 1e-12);
  EXPECT_NEAR(value(metrics, "full_slip_time"), 0.99e-3, 1e-12);
  EXPECT_NEAR(value(metrics, "slip_lead_time"), 0.94e-3, 1e-12);
  EXPECT_NEAR(value(metrics, "slip_lead_travel"), 0.94e-3 * 3e-3, 1e-14);
  EXPECT_NEAR(value(metrics, "micro_slip_force_ratio"), 0.05 * 0.3, 1e-9);
  const auto errors = slip_least_errors(handover::small_case(), linear_onset());
  EXPECT_NEAR(value(errors, "micro_slip_time"), 0.5e-3, 1e-12);
  EXPECT_NEAR(value(errors, "slip_lead_time"), 1e-3, 1e-12);
  EXPECT_NEAR(value(errors, "slip_lead_travel"), 3e-6, 1e-14);
}

TEST(SlipMetrics, OfTheFirstMicroSlipErrByCellsOfTheStuckBorder) {
  MechanicsRecord record = linear_onset();
  record.cell_errors = {{"stick_fraction_touchdown", 0.6, "1"}};
  const auto errors = slip_least_errors(handover::small_case(), record);
  EXPECT_NEAR(value(errors, "micro_slip_time"), 0.6 / 0.05 * 0.05e-3, 1e-12);
  EXPECT_NEAR(value(errors, "micro_slip_force_ratio"), 0.6 / 0.05 * 0.015, 1e-9);
  EXPECT_NEAR(value(errors, "slip_lead_time"), 0.6e-3 + 0.5e-3, 1e-12);
  EXPECT_NEAR(value(errors, "full_slip_time"), 0.5e-3, 1e-12);
}

TEST(SlipMetrics, AreNoneWithoutASlideOrWhatSticks) {
  Case input = handover::small_case();
  input.motion.stroke = 0;
  EXPECT_TRUE(slip_metrics(input, linear_onset()).empty());
  MechanicsRecord record = linear_onset();
  record.stick_share.assign(record.stick_share.size(), 0.0);
  EXPECT_TRUE(slip_metrics(handover::small_case(), record).empty());
  EXPECT_TRUE(slip_metrics(handover::small_case(), MechanicsRecord{}).empty());
}

TEST(SlipMetrics, HaveNoLeadWhereTheSlideEndsBeforeFullSlip) {
  MechanicsRecord record = linear_onset();
  record.stick_share = {0, 1, 1, 0.6, 0.5, 0, 0};
  const auto metrics = slip_metrics(handover::small_case(), record);
  EXPECT_FALSE(std::isnan(value(metrics, "micro_slip_time")));
  EXPECT_TRUE(std::isnan(value(metrics, "full_slip_time")));
  EXPECT_TRUE(std::isnan(value(metrics, "slip_lead_time")));
}

} // namespace
} // namespace ionskin::study
