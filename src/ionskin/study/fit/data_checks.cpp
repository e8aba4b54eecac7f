// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/fit/data_checks.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/study/fit/alignment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ionskin::study {
namespace {

constexpr double alike = 0.5;        // of a correlation, above which two signals have one shape
constexpr double clearly = 0.1;      // by which a correlation is better than another
constexpr double hopeless = 0.3;     // below it amplitudes go to 0
constexpr double sure = 0.8;         // of the correlation of a shifted signal
constexpr double other_size = 5;     // of the data, in the start's
constexpr double too_large = 30;     // likewise: no search gets there in reasonable time
constexpr double level_share = 1e-9; // of the largest value: values that differ by less are one

bool is_free(const FitModel& model, std::string_view key) {
  return std::ranges::any_of(model.parameters(), [&](const auto& one) { return one.key == key; });
}

/// Keys that move the signal in time.
bool frees_motion(const FitModel& model) {
  return std::ranges::any_of(model.parameters(),
                             [](const auto& one) { return one.key.starts_with("motion."); });
}

std::pair<double, double> range(const std::vector<double>& values) {
  const auto [least, largest] = std::ranges::minmax_element(values);
  return {*least, *largest};
}

double largest(const std::vector<double>& values) {
  const auto [least, most] = range(values);
  return std::max(std::abs(least), std::abs(most));
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

std::vector<double> shifted(const FitData& data, const electrochemistry::IonSolution& ions,
                            double time_shift) {
  DataAdjustment adjustment;
  adjustment.time_shift = time_shift;
  return predict(data, ions, adjustment);
}

void require_kept_sign(const Alignment& kept, const Alignment& turned, double correlation) {
  // A touch whose landing and leaving look alike turns its sign with a shift, too: of the two the
  // one without a shift is likelier.
  const bool in_place = correlation < -alike && -correlation > kept.correlation - clearly;
  const bool late = turned.correlation < -alike && correlation < alike &&
                    -turned.correlation > kept.correlation + clearly;
  if (in_place || late) {
    throw UserError(fmt::format(
        "the data correlate with minus the model ({:.2f}{})\n  = the electrodes are swapped, or "
        "the "
        "amplifier inverts: turn the sign of the column, start from the other sign of "
        "coupling.coefficient, or free data.gain",
        in_place ? correlation : turned.correlation,
        in_place
            ? ""
            : fmt::format(" when their clock is taken to be {:.4g} s late", turned.time_shift)));
  }
}

std::string shift_text(const FitData& data, const Alignment& kept, double correlation,
                       double time_shift) {
  const bool late = kept.time_shift > time_shift;
  return fmt::format(
      "the data correlate with the model by {:.2f}, and by {:.2f} when their clock is "
      "taken to be {:.4g} s {} ({} rows)",
      correlation, kept.correlation, std::abs(kept.time_shift - time_shift),
      late ? "late" : "early", data.values.size());
}

constexpr const char* shift_remedy =
    "let the fit find the shift, --free data.time_shift, or subtract it from the times";

/// Rows at the ends of the data's range that are left out: where an instrument would saturate.
struct Ends {
  bool least = false, largest = false;
};

/// What the model says of the ends once it is fitted to the other rows.
struct WithoutEnds {
  FitData rows;                                ///< the others
  std::vector<double> signal;                  ///< likewise
  double beyond_least = 0, beyond_largest = 0; ///< mean of the signal over the ends
  std::size_t least_rows = 0, largest_rows = 0;
};

WithoutEnds without_ends(const FitData& data, const std::vector<double>& signal, Ends ends) {
  const auto [least, most] = range(data.values);
  const double slack = 1e-6 * (most - least);
  WithoutEnds result{{data.column, data.unit, {}, {}}, {}};
  for (std::size_t row = 0; row < data.values.size(); ++row) {
    if (ends.least && data.values[row] <= least + slack) {
      result.beyond_least += signal[row];
      ++result.least_rows;
    } else if (ends.largest && data.values[row] >= most - slack) {
      result.beyond_largest += signal[row];
      ++result.largest_rows;
    } else {
      result.rows.time.push_back(data.time[row]);
      result.rows.values.push_back(data.values[row]);
      result.signal.push_back(signal[row]);
    }
  }
  result.beyond_least /= std::max(1.0, static_cast<double>(result.least_rows));
  result.beyond_largest /= std::max(1.0, static_cast<double>(result.largest_rows));
  return result;
}

/// Data that a model fitted to all rows but those at the ends of the range describes ten times as
/// well, and that it leaves by a tenth of the range there, are clipped.
/// @param left the sum of squares that the fit leaves
std::string clipping(const FitData& data, const std::vector<double>& signal, bool baseline,
                     bool drift, double left) {
  constexpr double beyond = 0.1, better = 0.1;
  const auto [least, most] = range(data.values);
  for (const Ends ends : {Ends{false, true}, Ends{true, false}, Ends{true, true}}) {
    const WithoutEnds others = without_ends(data, signal, ends);
    if (others.signal.size() < 4) {
      continue;
    }
    const LinearFit fit = linear_fit(others.rows, others.signal, baseline, drift);
    const double margin = beyond * (most - least);
    const bool above = fit.gain * others.beyond_largest + fit.baseline > most + margin;
    const bool below = fit.gain * others.beyond_least + fit.baseline < least - margin;
    if ((!ends.largest || above) && (!ends.least || below) && fit.left < better * left) {
      const std::string level = ends.largest && ends.least
                                    ? fmt::format("{:.4g} and {:.4g}", least, most)
                                    : fmt::format("{:.4g}", ends.largest ? most : least);
      return fmt::format("The data end at {} {} in {} rows, where the model that describes the "
                         "others goes beyond: the instrument is saturated. Leave the values of "
                         "these rows empty, or measure again in a wider range.",
                         level, data.unit, others.least_rows + others.largest_rows);
    }
  }
  return "";
}

/// A way to explain a misfit that no key of the case has.
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

/// The simplest explanation that leaves less than half, and not much more than all together.
std::optional<Explanation> find_explanation(const FitModel& model, const FitData& data,
                                            const electrochemistry::IonSolution& ions,
                                            const DataAdjustment& adjustment, double left) {
  const bool shift_free = is_free(model, "data.time_shift");
  const bool baseline_free = is_free(model, "data.baseline");
  const bool drift_free = is_free(model, "data.drift");
  const Alignment aligned =
      best_alignment(data, ions, is_free(model, "data.gain") ? Sign::free : Sign::kept);
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
                   linear_fit(data, shifted(data, ions, time_shift), level, slope)});
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

void require_signal(const FitData& data) {
  const auto [least, most] = range(data.values);
  if (least == 0 && most == 0) {
    throw UserError(fmt::format("the data hold no signal: all {} values of {} are 0\n  = check the "
                                "column, the range of the instrument and its cables",
                                data.values.size(), data.column));
  }
  if (most - least <= level_share * largest(data.values)) {
    throw UserError(
        fmt::format("the data are constant: all {} values of {} are {:.6g} {}\n  = check "
                    "the column, and whether the instrument is saturated",
                    data.values.size(), data.column, least, data.unit));
  }
}

DataAdjustment start_adjustment(const FitModel& model, const FitData& data,
                                const electrochemistry::IonSolution& start) {
  DataAdjustment adjustment;
  const bool gain = is_free(model, "data.gain"), baseline = is_free(model, "data.baseline"),
             drift = is_free(model, "data.drift");
  if (is_free(model, "data.time_shift")) {
    adjustment.time_shift = best_alignment(data, start, gain ? Sign::free : Sign::kept).time_shift;
  }
  const LinearFit fit =
      linear_fit(data, shifted(data, start, adjustment.time_shift), baseline, drift);
  adjustment.baseline = fit.baseline;
  adjustment.drift = fit.drift;
  if (gain && fit.gain != 0) {
    adjustment.gain = fit.gain;
  }
  return adjustment;
}

std::vector<std::string> compare_with_start(const FitModel& model, const FitData& data,
                                            const electrochemistry::IonSolution& start,
                                            const DataAdjustment& adjustment) {
  const std::vector<double> signal = shifted(data, start, adjustment.time_shift);
  const double size = deviation(data.values), start_size = deviation(signal);
  if (!(start_size > 0)) {
    throw UserError(
        fmt::format("the case that the fit starts from gives no {} at the times of the "
                    "data\n  = the time counts from the beginning of the run; start from "
                    "values that give a signal",
                    data.column));
  }
  const double r = correlation(data.values, signal);
  const Alignment kept = best_alignment(data, start, Sign::kept);
  std::vector<std::string> warnings;
  if (!is_free(model, "data.gain")) {
    require_kept_sign(kept, best_alignment(data, start, Sign::free), r);
    if (size > other_size * start_size || other_size * size < start_size) {
      const std::string text = fmt::format(
          "the data are {:.3g} times the size of the start's signal ({:.3g} {} and {:.3g} {} rms "
          "about the mean)",
          size / start_size, size, data.unit, start_size, data.unit);
      const std::string remedy =
          "check the unit in the header and the gain of the amplifier, start "
          "from values that give such a size, or free data.gain";
      if (size > too_large * start_size) {
        throw UserError(text + "\n  = " + remedy);
      }
      warnings.push_back("At the start " + text + ": " + remedy + ".");
    }
  }
  const bool shift_helps = kept.correlation > alike && kept.correlation > r + clearly;
  if (!is_free(model, "data.time_shift") && shift_helps) {
    const std::string text = shift_text(data, kept, r, adjustment.time_shift);
    if (r < hopeless && kept.correlation > sure && !frees_motion(model)) {
      throw UserError(text + "\n  = " + shift_remedy);
    }
    warnings.push_back("At the start " + text + ": " + shift_remedy + ".");
  }
  if (!shift_helps &&
      std::abs(r) < std::min(0.5, 4 / std::sqrt(static_cast<double>(data.values.size())))) {
    warnings.push_back(fmt::format("At the start the data do not follow the model at all "
                                   "(correlation {:.2f}): check the column, the motion of the case "
                                   "and the times.",
                                   r));
  }
  return warnings;
}

std::vector<std::string> explain_misfit(const FitModel& model, const FitData& data,
                                        const electrochemistry::IonSolution& start,
                                        const electrochemistry::IonSolution& end,
                                        const std::vector<double>& point) {
  constexpr double negligible = 1e-5; // of the variance
  constexpr double lost = 1e-4;       // of the start's signal: below it rounding shows
  const DataAdjustment adjustment = model.adjustment_at(point);
  const double left = left_of(data, predict(data, end, adjustment));
  const double variance =
      std::pow(deviation(data.values), 2) * static_cast<double>(data.values.size());
  std::vector<std::string> warnings;
  for (const std::string& key : data_keys()) {
    if (!is_free(model, key)) {
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
  const bool faded = deviation(shifted(data, end, adjustment.time_shift)) <
                     lost * deviation(shifted(data, start, adjustment.time_shift));
  const electrochemistry::IonSolution& shape = faded ? start : end;
  const std::string clipped =
      clipping(data, shifted(data, shape, adjustment.time_shift), is_free(model, "data.baseline"),
               is_free(model, "data.drift"), left);
  if (!clipped.empty()) {
    warnings.push_back(clipped);
  } else if (const auto found = find_explanation(model, data, shape, adjustment, left)) {
    warnings.push_back(fmt::format(
        "The fit leaves {:.3g} % of the variance, and {:.3g} % of that is "
        "explained by {}.",
        100 * left / variance, 100 * (1 - found->fit.left / left), words_of(*found, data)));
  }
  return warnings;
}

} // namespace ionskin::study
