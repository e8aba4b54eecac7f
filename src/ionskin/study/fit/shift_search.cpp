// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/fit/shift_search.hpp"

#include "ionskin/study/fit/alignment.hpp"
#include "ionskin/study/fit/data_adjustment.hpp"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ionskin::study {
namespace {

constexpr double parts_of_row = 64;       // grid points in the interval of a row
constexpr double most_of_grid = 128;      // grid points on either side of the middle
constexpr double most_parts = 200'000;    // parts into which a run is cut to find abrupt changes
constexpr std::size_t most_instants = 16; // abrupt changes that count
/// Change of one row by which a change counts as abrupt, over the signal's standard deviation [1].
constexpr double least_change = 0.02;

double row_interval(const FitData& data) {
  const double length = data.time.back() - data.time.front();
  return length > 0 ? length / static_cast<double>(data.time.size() - 1) : 1.0;
}

/// Changes of the predicted signal from each part of equal length to the next.
/// @param begin, length of the first part [s]
std::vector<double> changes(const FitData& data, const electrochemistry::IonSolution& ions,
                            double begin, double length, std::size_t count) {
  FitData parts{data.column, data.unit, {}, {}, data.at_one_rate};
  for (std::size_t i = 0; i <= count; ++i) {
    parts.time.push_back(begin + static_cast<double>(i) * length);
  }
  const std::vector<double> signal = predict(parts, ions);
  std::vector<double> result;
  for (std::size_t i = 0; i < count; ++i) {
    result.push_back(std::abs(signal[i + 1] - signal[i]));
  }
  return result;
}

/// Instants at which the signal of a run changes abruptly against the interval of a row [s].
/// @param deviation standard deviation of the signal [unit of the data]
std::vector<double> abrupt_instants(const FitData& data, const electrochemistry::IonSolution& ions,
                                    double deviation) {
  const double begin = ions.time.front(), span = ions.time.back() - begin;
  const double interval = row_interval(data);
  const double length = std::max(interval / parts_of_row, span / most_parts);
  const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(span / length)));
  const std::vector<double> coarse = changes(data, ions, begin, length, count);
  // The mean current of a part holds its charge; in a row this charge is diluted.
  const double in_row = is_current(data) ? std::min(1.0, length / interval) : 1.0;
  std::vector<std::size_t> largest;
  for (std::size_t i = 0; i < count; ++i) {
    if (coarse[i] * in_row > least_change * deviation) {
      largest.push_back(i);
    }
  }
  std::ranges::sort(largest, [&](std::size_t a, std::size_t b) { return coarse[a] > coarse[b]; });
  largest.resize(std::min(largest.size(), most_instants));
  std::vector<double> instants;
  for (const std::size_t i : largest) {
    const double from = begin + (static_cast<double>(i) - 1) * length, fine = length / parts_of_row;
    const std::vector<double> within =
        changes(data, ions, from, fine, static_cast<std::size_t>(2 * parts_of_row));
    const auto at = std::ranges::max_element(within) - within.begin();
    instants.push_back(from + (static_cast<double>(at) + 0.5) * fine);
  }
  return instants;
}

} // namespace

std::vector<double> shifts_to_compare(const FitData& data,
                                      const electrochemistry::IonSolution& ions, double about,
                                      double reach) {
  const double interval = row_interval(data);
  const int parts =
      static_cast<int>(std::clamp(std::ceil(parts_of_row * reach / interval), 4.0, most_of_grid));
  std::vector<double> ends;
  for (int part = -parts; part <= parts; ++part) {
    ends.push_back(about + reach * part / parts);
  }
  std::vector<double> borders = data.time; // of rows
  const std::vector<double> starts = interval_starts(data, ions.time.front());
  borders.insert(borders.end(), starts.begin(), starts.end());
  std::ranges::sort(borders);
  borders.erase(std::ranges::unique(borders).begin(), borders.end());
  const double deviation = study::deviation(predict_shifted(data, ions, about));
  for (const double instant : abrupt_instants(data, ions, deviation)) {
    for (auto border = std::ranges::lower_bound(borders, instant + about - reach);
         border != borders.end() && *border <= instant + about + reach; ++border) {
      ends.push_back(*border - instant);
    }
  }
  std::ranges::sort(ends);
  std::vector<double> shifts;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (i > 0) {
      shifts.push_back((ends[i - 1] + ends[i]) / 2);
    }
    shifts.push_back(ends[i]);
  }
  return shifts;
}

LeastOfShifts least_of_shifts(const std::vector<double>& shifts,
                              const std::function<double(double time_shift)>& function) {
  constexpr int bits = 26;
  std::size_t best = 0;
  double least = function(shifts[0]);
  for (std::size_t i = 1; i < shifts.size(); ++i) {
    if (const double value = function(shifts[i]); value < least) {
      best = i;
      least = value;
    }
  }
  // The place is searched relative to the best shift, whose own digits would limit its precision.
  const double at = shifts[best], low = shifts[best > 0 ? best - 1 : best],
               high = shifts[std::min(best + 1, shifts.size() - 1)];
  if (!(high > low)) {
    return {at, least};
  }
  const auto [place, value] = boost::math::tools::brent_find_minima(
      [&](double from_best) { return function(at + from_best); }, low - at, high - at, bits);
  return value < least ? LeastOfShifts{at + place, value} : LeastOfShifts{at, least};
}

} // namespace ionskin::study
