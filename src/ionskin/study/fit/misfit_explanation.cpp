// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/fit/misfit_explanation.hpp"

#include "ionskin/study/fit/alignment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <optional>
#include <utility>

namespace ionskin::study {
namespace {

/// Ends of the data's range, smallest or largest value, whose rows are left out since an instrument
/// would saturate there.
struct Ends {
  bool least = false, largest = false;
};

/// Rows at an end of the data's range: their number, and means of the signal and the time over
/// them.
struct EndRows {
  std::size_t rows = 0;
  double signal = 0, time = 0; ///< [unit of the signal], [s]

  /// Value of a linear fit in the mean of these rows [unit of the data].
  /// @param begin first time of the rows that were fitted [s]
  double value(const LinearFit& fit, double begin) const {
    return fit.gain * signal + fit.baseline + fit.drift * (time - begin);
  }
};

/// Data without the rows at the ends of their range, the signal there, and the rows at the ends.
struct WithoutEnds {
  FitData rows;               ///< remaining rows
  std::vector<double> signal; ///< signal at the remaining rows
  EndRows least, largest;
};

WithoutEnds without_ends(const FitData& data, const std::vector<double>& signal, Ends ends) {
  const auto [least, most] = std::ranges::minmax(data.values);
  const double slack = 1e-6 * (most - least);
  WithoutEnds result{{data.column, data.unit, {}, {}}, {}};
  for (std::size_t row = 0; row < data.values.size(); ++row) {
    const bool at_least = ends.least && data.values[row] <= least + slack;
    if (at_least || (ends.largest && data.values[row] >= most - slack)) {
      EndRows& end = at_least ? result.least : result.largest;
      ++end.rows;
      end.signal += signal[row];
      end.time += data.time[row];
    } else {
      result.rows.time.push_back(data.time[row]);
      result.rows.values.push_back(data.values[row]);
      result.signal.push_back(signal[row]);
    }
  }
  for (EndRows* end : {&result.least, &result.largest}) {
    const double rows = std::max(1.0, static_cast<double>(end->rows));
    end->signal /= rows;
    end->time /= rows;
  }
  return result;
}

/// True if the ends look like limits of an instrument, which noise does not repeat: one value
/// several times, or a value and its negative.
bool are_limits(const FitData& data, const WithoutEnds& others, Ends ends) {
  const auto [least, most] = std::ranges::minmax(data.values);
  const bool twice =
      (!ends.least || others.least.rows > 1) && (!ends.largest || others.largest.rows > 1);
  return twice || (ends.least && ends.largest && std::abs(least + most) < 1e-6 * (most - least));
}

/// Sentence on a saturated instrument; empty where there is no sign of it. Data count as clipped if
/// a model fitted to all rows but those at the ends of the range exceeds these by a tenth of the
/// range, and either describes the remaining rows ten times as well, or the ends are limits whose
/// rows hold far more of the misfit than as many others.
/// @param left sum of squares of the residuals of the fit
std::string clipping(const FitData& data, const std::vector<double>& signal, bool baseline,
                     bool drift, double left) {
  constexpr double beyond = 0.1, better = 0.1, outlying = 50;
  const auto [least, most] = std::ranges::minmax(data.values);
  for (const Ends ends : {Ends{false, true}, Ends{true, false}, Ends{true, true}}) {
    const WithoutEnds others = without_ends(data, signal, ends);
    if (others.signal.size() < 4) {
      continue;
    }
    const LinearFit fit = linear_fit(others.rows, others.signal, baseline, drift);
    const double margin = beyond * (most - least);
    const double begin = others.rows.time.front();
    const bool above = others.largest.value(fit, begin) > most + margin;
    const bool below = others.least.value(fit, begin) < least - margin;
    const double of_ends =
        (left - fit.left) / static_cast<double>(others.least.rows + others.largest.rows);
    const double of_others = fit.left / static_cast<double>(others.signal.size());
    const bool clear = fit.left < better * left ||
                       (are_limits(data, others, ends) && of_ends > outlying * of_others);
    if ((!ends.largest || above) && (!ends.least || below) && clear) {
      const std::string level = ends.largest && ends.least
                                    ? fmt::format("{:.4g} and {:.4g}", least, most)
                                    : fmt::format("{:.4g}", ends.largest ? most : least);
      return fmt::format("The data end at {} {} in {} rows, where the model that describes the "
                         "others goes beyond: the instrument is saturated. Leave the values of "
                         "these rows empty, or measure again in a wider range.",
                         level, data.unit, others.least.rows + others.largest.rows);
    }
  }
  return "";
}

/// Sentence on outliers, few rows that hold nearly all of the misfit; empty where there are none.
/// @param left sum of squares of the residuals of the fit
/// @param variance sum of squares of the data about their mean
std::string outlying_rows(const FitData& data, const std::vector<double>& fitted, double left,
                          double variance) {
  constexpr double worth_naming = 0.05, most_of_it = 0.8, few = 0.03;
  if (!(left > worth_naming * variance)) {
    return "";
  }
  std::vector<std::pair<double, double>> squares; // squared residuals with their times
  for (std::size_t row = 0; row < fitted.size(); ++row) {
    squares.emplace_back(std::pow(data.values[row] - fitted[row], 2), data.time[row]);
  }
  std::ranges::sort(squares, std::greater<>());
  double held = 0;
  std::size_t rows = 0;
  while (rows < squares.size() && held < most_of_it * left) {
    held += squares[rows++].first;
  }
  if (static_cast<double>(rows) > few * static_cast<double>(squares.size())) {
    return "";
  }
  return fmt::format("The fit leaves {:.3g} % of the variance, and {} of {} rows hold {:.3g} % of "
                     "that, the worst at {:.4g} s: they are outliers, or peaks that the instrument "
                     "smooths or the model resolves otherwise. Leave their values empty and fit "
                     "again: the estimates should not change.",
                     100 * left / variance, rows, squares.size(), 100 * held / left,
                     squares.front().second);
}

/// Time shift, baseline and drift that may explain a misfit, with the linear fit that results.
struct Explanation {
  bool shift = false, baseline = false, drift = false;
  double time_shift = 0;
  LinearFit fit;
};

std::string joined(const std::vector<std::string>& parts, const char* between) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == parts.size() ? between : ", ") + parts[i];
  }
  return text;
}

std::string words_of(const Explanation& one, const FitData& data) {
  std::vector<std::string> parts, keys;
  if (one.shift) {
    parts.push_back(fmt::format("a time shift of {:.4g} s", one.time_shift));
    keys.emplace_back("data.time_shift");
  }
  if (one.baseline) {
    parts.push_back(fmt::format("a baseline of {:.4g} {}", one.fit.baseline, data.unit));
    keys.emplace_back("data.baseline");
  }
  if (one.drift) {
    parts.push_back(fmt::format("a drift of {:.4g} {}/s", one.fit.drift, data.unit));
    keys.emplace_back("data.drift");
  }
  return fmt::format("{}: --free {}", joined(parts, " and "), joined(keys, ","));
}

double left_of(const FitData& data, const std::vector<double>& fitted) {
  double squares = 0;
  for (std::size_t row = 0; row < fitted.size(); ++row) {
    squares += (data.values[row] - fitted[row]) * (data.values[row] - fitted[row]);
  }
  return squares;
}

/// Finds the simplest explanation that leaves less than half of the misfit, and not much more than
/// all explanations together.
/// @param left sum of squares of the residuals of the fit
std::optional<Explanation> find_explanation(const FitModel& model, const FitData& data,
                                            const electrochemistry::IonSolution& ions,
                                            const DataAdjustment& adjustment, double left) {
  const bool shift_free = model.frees("data.time_shift");
  const bool baseline_free = model.frees("data.baseline");
  const bool drift_free = model.frees("data.drift");
  const Alignment aligned =
      best_alignment(data, ions, model.frees("data.gain") ? Sign::free : Sign::kept);
  std::vector<Explanation> all;
  for (const auto& [shift, baseline, drift] :
       std::initializer_list<std::array<bool, 3>>{{true, false, false},
                                                  {false, true, false},
                                                  {true, true, false},
                                                  {false, true, true},
                                                  {true, true, true}}) {
    if ((shift && shift_free) || (baseline && baseline_free && !drift) || (drift && drift_free)) {
      continue;
    }
    const bool level = baseline || baseline_free, slope = drift || drift_free;
    const double time_shift = shift ? aligned.time_shift : adjustment.time_shift;
    all.push_back({shift, baseline && !baseline_free, drift, time_shift,
                   linear_fit(data, predict_shifted(data, ions, time_shift), level, slope)});
  }
  double least = left;
  for (const Explanation& one : all) {
    least = std::min(least, one.fit.left);
  }
  for (const Explanation& one : all) {
    if (one.fit.left < 0.5 * left && one.fit.left <= std::max(2 * least, 0.02 * left)) {
      return one;
    }
  }
  return std::nullopt;
}

} // namespace

std::vector<std::string> explain_misfit(const FitModel& model, const FitData& data,
                                        const electrochemistry::IonSolution& start,
                                        const electrochemistry::IonSolution& end,
                                        const std::vector<double>& point) {
  constexpr double negligible = 1e-5; // share of the variance that need not be explained
  constexpr double lost = 1e-4;       // share of the start's signal below which rounding shows
  const DataAdjustment adjustment = model.adjustment_at(point);
  const double left = left_of(data, predict(data, end, adjustment));
  const double variance =
      std::pow(deviation(data.values), 2) * static_cast<double>(data.values.size());
  std::vector<std::string> warnings;
  for (const std::string& key : data_keys()) {
    if (!model.frees(key)) {
      continue;
    }
    DataAdjustment without = adjustment;
    without.of(key) = DataAdjustment().of(key);
    const double share = 1 - left / left_of(data, predict(data, end, without));
    if (share > 0.5) {
      const std::string unit = data_key_unit(key, data.unit);
      warnings.push_back(fmt::format(
          "{} = {:.4g}{} explains {:.3g} % of the misfit that is there without it{}.", key,
          DataAdjustment(adjustment).of(key), unit == "1" ? "" : " " + unit, 100 * share,
          key == "data.gain" && adjustment.gain < 0
              ? "; it is negative: the electrodes are swapped, or the amplifier inverts"
              : ""));
    }
  }
  if (left < negligible * variance) {
    return warnings;
  }
  const bool faded = deviation(predict_shifted(data, end, adjustment.time_shift)) <
                     lost * deviation(predict_shifted(data, start, adjustment.time_shift));
  const electrochemistry::IonSolution& shape = faded ? start : end;
  const std::string clipped =
      clipping(data, predict_shifted(data, shape, adjustment.time_shift),
               model.frees("data.baseline"), model.frees("data.drift"), left);
  if (!clipped.empty()) {
    warnings.push_back(clipped);
  } else if (const auto found = find_explanation(model, data, shape, adjustment, left)) {
    warnings.push_back(fmt::format(
        "The fit leaves {:.3g} % of the variance, and {:.3g} % of that is "
        "explained by {}.",
        100 * left / variance, 100 * (1 - found->fit.left / left), words_of(*found, data)));
  } else if (std::string outliers =
                 outlying_rows(data, predict(data, end, adjustment), left, variance);
             !outliers.empty()) {
    warnings.push_back(std::move(outliers));
  }
  return warnings;
}

} // namespace ionskin::study
