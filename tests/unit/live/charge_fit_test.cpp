// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/training/charge_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::live {
namespace {

/// The charge that relaxes with one rate behind a drive that rises and rests, in closed form.
ChargeRecord relaxing(double rate) {
  ChargeRecord record;
  for (int i = 0; i <= 400; ++i) {
    const double time = 0.01 * i, ramp = std::min(time, 1.0),
                 rise = ramp - (1 - std::exp(-rate * ramp)) / rate,
                 filtered = time <= 1 ? rise : 1 - (1 - rise) * std::exp(-rate * (time - 1));
    record.time.push_back(time);
    record.drive.push_back(ramp);
    record.charge[0].push_back(2 * ramp - filtered);
    record.charge[1].push_back(ramp);
  }
  return record;
}

TEST(ChargeFit, FindsRateAndWeights) {
  const std::vector<ChargeRecord> records{relaxing(3)};
  const auto rates = choose_rates({{records, 1}}, {0.1, 0.5, 3, 20, 100}, 1, 1);
  ASSERT_EQ(rates, std::vector<double>{3});
  const ChargeModel model = fit_charges(records, 1, rates).model;
  EXPECT_NEAR(model.direct[0], 2, 1e-6);
  EXPECT_NEAR(model.residue[0], -1, 1e-6);
  EXPECT_NEAR(model.direct[1], 1, 1e-6);
  EXPECT_NEAR(model.residue[1], 0, 1e-6);
}

TEST(ChargeFit, TakesAsManyRatesAsUnseenRowsNeed) {
  ChargeRecord both = relaxing(3);
  const ChargeRecord fast = relaxing(20);
  const std::vector<double> candidates{0.1, 0.5, 3, 20, 100};
  EXPECT_EQ(choose_rates({{{both}, 1}}, candidates, 1, 4), std::vector<double>{3});
  for (std::size_t i = 0; i < both.time.size(); ++i) {
    both.charge[0][i] += 0.5 * fast.charge[0][i];
  }
  EXPECT_EQ(choose_rates({{{both}, 1}}, candidates, 1, 4), (std::vector<double>{3, 20}));
}

TEST(ChargeFit, TellsWhatSpreadsFromWhatItsOwnShearDrives) {
  // A charge that comes from beside, on both sides alike, at a rate that the region has not.
  ChargeRecord record = relaxing(3);
  const ChargeRecord beside = relaxing(20);
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    const double came = 2 * beside.charge[1][i] - beside.charge[0][i];
    for (auto& charge : record.charge) {
      charge[i] += 0.7 * came;
    }
    record.spread.push_back(came);
  }
  const ChargeFit fit = fit_charges({record}, 1, {3});
  EXPECT_NEAR(fit.model.direct[0], 2, 1e-6);
  EXPECT_NEAR(fit.model.direct[1], 1, 1e-6);
  EXPECT_NEAR(fit.model.residue[0], -1, 1e-6);
  ASSERT_EQ(fit.spread.size(), 1u);
  EXPECT_NEAR(fit.spread[0], 0.7, 1e-6);
  const double with = unseen_error({record}, 1, {3});
  record.spread.clear();
  EXPECT_LT(with, 1e-2 * unseen_error({record}, 1, {3}));
  EXPECT_TRUE(fit_charges({record}, 1, {3}).spread.empty());
}

} // namespace
} // namespace ionskin::live
