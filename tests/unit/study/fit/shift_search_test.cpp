// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/fit/shift_search.hpp"

#include "ionskin/study/fit/alignment.hpp"
#include "ionskin/study/fit/data_adjustment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ionskin::study {
namespace {

/// Run of 4 s whose charge rises within some microseconds shortly before the end of a row of 10 ms,
/// and falls likewise shortly behind the begin of another row.
electrochemistry::IonSolution two_spikes() {
  electrochemistry::IonSolution ions;
  const double up = 0.49997, down = 2.50002, decay = 4e-6;
  std::vector<double> times{0};
  for (double time = 0.05; time < 4; time += 0.05) {
    times.push_back(time);
  }
  for (const double event : {up, down}) {
    for (int i = 0; i < 40; ++i) {
      times.push_back(event + 1e-6 * i);
    }
  }
  times.push_back(4);
  std::ranges::sort(times);
  for (const double time : times) {
    const double risen = time > up ? 1 - std::exp(-(time - up) / decay) : 0,
                 fallen = time > down ? 1 - std::exp(-(time - down) / decay) : 0;
    ions.time.push_back(time);
    ions.charge_top.push_back(1e-6 * (risen - 0.8 * fallen + 0.1 * std::sin(time)));
    ions.charge_bottom.push_back(-ions.charge_top.back());
  }
  return ions;
}

FitData readings(const electrochemistry::IonSolution& ions) {
  FitData data{"current_top", "A", {}, {}, true};
  for (int row = 1; row <= 400; ++row) {
    data.time.push_back(0.01 * row);
  }
  data.values = predict(data, ions);
  return data;
}

// Only shifts within some 50 us put both spikes into the right rows.
TEST(ShiftSearch, FindsARangeThatIsFarNarrowerThanARow) {
  const auto ions = two_spikes();
  for (const double shift : {0.0, 0.004, 0.02, -0.0267}) {
    FitData data = readings(ions);
    for (double& time : data.time) {
      time += shift;
    }
    const Alignment found = best_alignment(data, ions, Sign::kept);
    EXPECT_NEAR(found.time_shift, shift, 5e-5);
    EXPECT_GT(found.correlation, 0.9999);
  }
}

TEST(ShiftSearch, ComparesShiftsOnBothSidesOfEachAbruptChange) {
  const auto ions = two_spikes();
  const auto shifts = shifts_to_compare(readings(ions), ions, 0, 0.01);
  EXPECT_TRUE(std::ranges::is_sorted(shifts));
  EXPECT_NEAR(shifts.front(), -0.01, 1e-3);
  EXPECT_NEAR(shifts.back(), 0.01, 1e-3);
  const auto within = [&](double low, double high) {
    return std::ranges::any_of(shifts, [&](double one) { return one > low && one < high; });
  };
  EXPECT_TRUE(within(-2e-5, 3e-5)); // both spikes in their rows
}

TEST(ShiftSearch, FindsTheLeastOfAFunctionBetweenItsPoints) {
  const auto least =
      least_of_shifts({-1, 0, 1, 2}, [](double shift) { return std::pow(shift - 0.7, 2) + 3; });
  EXPECT_NEAR(least.time_shift, 0.7, 1e-6);
  EXPECT_NEAR(least.value, 3, 1e-12);
  EXPECT_EQ(least_of_shifts({0.5}, [](double shift) { return shift; }).time_shift, 0.5);
}

} // namespace
} // namespace ionskin::study
