// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/fit/alignment.hpp"

#include "ionskin/base/value_at.hpp"
#include "ionskin/study/fit/data_adjustment.hpp"
#include "ionskin/study/fit/shift_search.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace ionskin::study {
namespace {

constexpr double cells_of_longer = 2048;

/// Means of a signal over intervals of equal length on the time axis, from interval number `first`
/// on; the weight of each is the part of it that is known, 0 to 1.
struct Cells {
  std::int64_t first = 0;
  std::vector<double> values, weights;
};

/// Averages data over intervals. A mean holds for the interval that ends at its row; other values
/// are linear between their rows.
/// @param begin of interval 0 [s]
/// @param length of an interval [s]
Cells data_cells(const FitData& data, double begin, double length) {
  const std::vector<double> starts = interval_starts(data, begin);
  Cells cells;
  const auto index = [&](double time) {
    return static_cast<std::int64_t>(std::floor((time - begin) / length));
  };
  cells.first = index(is_mean(data) ? starts.front() : data.time.front());
  const auto count = static_cast<std::size_t>(index(data.time.back()) - cells.first + 1);
  if (!is_mean(data)) {
    cells.weights.assign(count, 1.0);
    for (std::size_t i = 0; i < count; ++i) {
      const double middle = static_cast<double>(cells.first) + static_cast<double>(i) + 0.5;
      cells.values.push_back(base::value_at(data.time, data.values, begin + middle * length));
    }
    return cells;
  }
  cells.values.assign(count, 0.0);
  cells.weights.assign(count, 0.0);
  for (std::size_t row = 0; row < data.time.size(); ++row) {
    const double from = (starts[row] - begin) / length - static_cast<double>(cells.first);
    const double to = (data.time[row] - begin) / length - static_cast<double>(cells.first);
    for (double at = std::max(0.0, from); at < to && at < static_cast<double>(count);) {
      const double next = std::min(to, std::floor(at) + 1);
      const auto cell = static_cast<std::size_t>(at);
      cells.values[cell] += (next - at) * data.values[row];
      cells.weights[cell] += next - at;
      at = next;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    cells.values[i] /= cells.weights[i] > 0 ? cells.weights[i] : 1.0;
    cells.weights[i] = std::min(1.0, cells.weights[i]);
  }
  return cells;
}

std::vector<double> run_cells(const FitData& data, const electrochemistry::IonSolution& ions,
                              double length) {
  const double begin = ions.time.front();
  const auto count =
      static_cast<std::size_t>(std::ceil((ions.time.back() - begin) / length - 1e-9));
  FitData sampled{data.column, data.unit, {}, {}, data.at_one_rate};
  const double place = is_mean(data) ? 1.0 : 0.5;
  for (std::size_t i = 0; i < count; ++i) {
    sampled.time.push_back(begin + (static_cast<double>(i) + place) * length);
  }
  return predict(sampled, ions);
}

/// Running means of values over as many intervals as a row of the data spans.
/// @param cells number of intervals that a row spans
std::vector<double> smoothed(const std::vector<double>& values, double cells) {
  const auto width = static_cast<std::size_t>(std::max(1.0, std::round(cells)));
  std::vector<double> result;
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += values[i] - (i >= width ? values[i - width] : 0.0);
    result.push_back(sum / static_cast<double>(width));
  }
  return result;
}

double correlation_at(const FitData& data, const electrochemistry::IonSolution& ions,
                      double time_shift) {
  return correlation(data.values, predict_shifted(data, ions, time_shift));
}

/// Best shift within one step of a given shift, for the sign of its correlation.
Alignment refined(const FitData& data, const electrochemistry::IonSolution& ions,
                  const Alignment& about, double step) {
  const double sign = about.correlation < 0 ? -1 : 1;
  const auto unlikeness = [&](double shift) { return -sign * correlation_at(data, ions, shift); };
  const auto least =
      least_of_shifts(shifts_to_compare(data, ions, about.time_shift, step), unlikeness);
  return {least.time_shift, -sign * least.value};
}

} // namespace

Alignment best_alignment(const FitData& data, const electrochemistry::IonSolution& ions,
                         Sign sign) {
  const double begin = ions.time.front(), span = ions.time.back() - begin;
  const double length = std::max(span, data.time.back() - data.time.front()) / cells_of_longer;
  const Cells cells = data_cells(data, begin, length);
  std::vector<double> signal = run_cells(data, ions, length);
  double step = length; // interval between the shifts that are compared [s]
  if (is_mean(data)) {
    const std::vector<double> starts = interval_starts(data, begin);
    std::vector<double> intervals;
    for (std::size_t row = 0; row < starts.size(); ++row) {
      intervals.push_back(data.time[row] - starts[row]);
    }
    const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
    std::nth_element(intervals.begin(), middle, intervals.end());
    signal = smoothed(signal, *middle / length);
    step += *middle; // rows are means: the best shift on the grid is half a row too early
  }
  const double before = is_current(data) ? 0.0 : signal.front();
  const double behind = is_current(data) ? 0.0 : signal.back();
  const auto count = static_cast<std::int64_t>(cells.values.size());
  const auto run = static_cast<std::int64_t>(signal.size());
  const std::int64_t overlap = std::max<std::int64_t>(1, std::min(count, run) / 2);
  double w = 0, y = 0, yy = 0;
  for (std::size_t i = 0; i < cells.values.size(); ++i) {
    w += cells.weights[i];
    y += cells.weights[i] * cells.values[i];
    yy += cells.weights[i] * cells.values[i] * cells.values[i];
  }
  const double spread = yy - y * y / w;
  std::array<Alignment, 2> of_sign; // best shifts with positive and with negative correlation
  for (std::int64_t lag = cells.first - run + overlap; lag <= cells.first + count - overlap;
       ++lag) {
    double s = 0, ss = 0, sy = 0;
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t j = cells.first + i - lag;
      const auto at = static_cast<std::size_t>(i);
      const double value = j < 0 ? before : j >= run ? behind : signal[static_cast<std::size_t>(j)];
      const double weighted = cells.weights[at] * value;
      s += weighted;
      ss += weighted * value;
      sy += weighted * cells.values[at];
    }
    const double scale = std::sqrt(std::max(0.0, ss - s * s / w) * spread);
    const double r = scale > 0 ? (sy - s * y / w) / scale : 0.0;
    Alignment& best = of_sign[r < 0 ? 1 : 0];
    if (std::abs(r) > std::abs(best.correlation)) {
      best = {static_cast<double>(lag) * length, r};
    }
  }
  // A sharp signal correlates best between two shifts of the grid: both signs are refined before
  // they are compared.
  Alignment likest;
  for (Alignment at_lag : of_sign) {
    if (at_lag.correlation == 0 || (at_lag.correlation < 0 && sign != Sign::free)) {
      continue;
    }
    const Alignment between = refined(data, ions, at_lag, step);
    at_lag.correlation = correlation_at(data, ions, at_lag.time_shift);
    for (const Alignment& one : {at_lag, between}) {
      if (std::abs(one.correlation) > std::abs(likest.correlation)) {
        likest = one;
      }
    }
  }
  return likest;
}

double deviation(const std::vector<double>& values) {
  double mean = 0, squares = 0;
  for (const double value : values) {
    mean += value / static_cast<double>(values.size());
  }
  for (const double value : values) {
    squares += (value - mean) * (value - mean) / static_cast<double>(values.size());
  }
  return std::sqrt(squares);
}

double correlation(const std::vector<double>& first, const std::vector<double>& second) {
  const auto map = [](const std::vector<double>& values) {
    return Eigen::Map<const Eigen::ArrayXd>(values.data(),
                                            static_cast<Eigen::Index>(values.size()));
  };
  const Eigen::ArrayXd a = map(first) - map(first).mean(), b = map(second) - map(second).mean();
  const double scale = a.matrix().norm() * b.matrix().norm();
  return scale > 0 ? (a * b).sum() / scale : 0.0;
}

LinearFit linear_fit(const FitData& data, const std::vector<double>& signal, bool baseline,
                     bool drift) {
  const auto rows = static_cast<Eigen::Index>(signal.size());
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(rows, 3);
  Eigen::VectorXd values(rows);
  double power = 0;
  for (Eigen::Index i = 0; i < rows; ++i) {
    const auto row = static_cast<std::size_t>(i);
    columns(i, 0) = signal[row];
    columns(i, 1) = baseline ? 1.0 : 0.0;
    columns(i, 2) = drift ? data.time[row] - data.time.front() : 0.0;
    values[i] = data.values[row];
    power += signal[row] * signal[row];
  }
  const double size = power > 0 ? std::sqrt(power / static_cast<double>(rows)) : 1.0;
  columns.col(0) /= size; // else a signal of 1e-9 A stands beside a baseline column of 1
  const Eigen::VectorXd found = columns.completeOrthogonalDecomposition().solve(values);
  return {found[0] / size, found[1], found[2], (values - columns * found).squaredNorm()};
}

} // namespace ionskin::study
