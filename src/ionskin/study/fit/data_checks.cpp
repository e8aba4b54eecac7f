// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/fit/data_checks.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/largest.hpp"
#include "ionskin/study/fit/alignment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ionskin::study {
namespace {

constexpr double alike = 0.5;    // correlation above which two signals have the same shape
constexpr double clearly = 0.1;  // difference by which one correlation is better than another
constexpr double hopeless = 0.3; // correlation below which a fit drives amplitudes to 0
constexpr double nearer = 0.5;   // ratio below which one time shift is much smaller than another
constexpr double sure = 0.8;     // correlation of a shifted signal above which the shift is sure
constexpr double other_size = 5; // ratio of the sizes of data and start's signal that is warned of
constexpr double too_large = 30; // ratio of sizes that no search bridges in reasonable time
constexpr double too_small = 1e-6;   // the same for data that are too small
constexpr double level_share = 1e-9; // relative difference below which values count as equal

/// True if the model frees keys that move the signal in time.
bool frees_motion(const FitModel& model) {
  return std::ranges::any_of(model.parameters(),
                             [](const auto& one) { return one.key.starts_with("motion."); });
}

/// @param correlation of the data with the model, as the clock of the data says
void require_kept_sign(const Alignment& kept, const Alignment& turned, double correlation) {
  // Where landing and leaving of a touch give signals of the same shape and opposite sign, a shift
  // reverses the sign of the correlation, too. The much smaller shift is more likely then.
  const bool in_place = correlation < -alike && -correlation > kept.correlation - clearly;
  const bool near = std::abs(turned.time_shift) < nearer * std::abs(kept.time_shift);
  const bool late = turned.correlation < -alike && correlation < alike &&
                    (-turned.correlation > kept.correlation + clearly ||
                     (-turned.correlation > kept.correlation - clearly && near));
  if (in_place || late) {
    throw UserError(fmt::format(
        "the data correlate with minus the model ({:.2f}{})\n  = the electrodes are swapped, or "
        "the "
        "amplifier inverts: turn the sign of the column, start from the other sign of "
        "coupling.coefficient, or free data.gain{}",
        in_place ? correlation : turned.correlation,
        in_place ? ""
                 : fmt::format(" when their clock is taken to be {:.4g} s late", turned.time_shift),
        kept.correlation > alike
            ? fmt::format(
                  "; or their clock is {:.4g} s late ({:.2f}): subtract that from the times",
                  kept.time_shift, kept.correlation)
            : ""));
  }
}

std::string shift_text(const FitData& data, const Alignment& best, double correlation,
                       double time_shift) {
  const bool late = best.time_shift > time_shift;
  return fmt::format(
      "the data correlate with the model by {:.2f}, and by {:.2f} when their clock is "
      "taken to be {:.4g} s {} ({} rows)",
      correlation, best.correlation, std::abs(best.time_shift - time_shift),
      late ? "late" : "early", data.values.size());
}

constexpr const char* shift_remedy =
    "let the fit find the shift, --free data.time_shift, or subtract it from the times";

} // namespace

void require_signal(const FitData& data) {
  const auto [least, most] = std::ranges::minmax(data.values);
  if (least == 0 && most == 0) {
    throw UserError(fmt::format("the data hold no signal: all {} values of {} are 0\n  = check the "
                                "column, the range of the instrument and its cables",
                                data.values.size(), data.column));
  }
  if (most - least <= level_share * base::largest_magnitude(data.values)) {
    throw UserError(
        fmt::format("the data are constant: all {} values of {} are {:.6g} {}\n  = check "
                    "the column, and whether the instrument is saturated",
                    data.values.size(), data.column, least, data.unit));
  }
}

DataAdjustment start_adjustment(const FitModel& model, const FitData& data,
                                const electrochemistry::IonSolution& start) {
  DataAdjustment adjustment;
  const bool gain = model.frees("data.gain"), baseline = model.frees("data.baseline"),
             drift = model.frees("data.drift");
  if (model.frees("data.time_shift")) {
    adjustment.time_shift = best_alignment(data, start, gain ? Sign::free : Sign::kept).time_shift;
  }
  const LinearFit fit =
      linear_fit(data, predict_shifted(data, start, adjustment.time_shift), baseline, drift);
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
  const std::vector<double> signal = predict_shifted(data, start, adjustment.time_shift);
  const double size = deviation(data.values), start_size = deviation(signal);
  if (!(start_size > 0)) {
    throw UserError(
        fmt::format("the case that the fit starts from gives no {} at the times of the "
                    "data, {:.4g} to {:.4g} s of a run of {:.4g} s\n  = the time counts from the "
                    "beginning of the run: check the unit in the header of the time, or start "
                    "from values that give a signal",
                    data.column, data.time.front(), data.time.back(), start.time.back()));
  }
  const double r = correlation(data.values, signal);
  // With a free gain, data that are like minus the model agree with it.
  const bool gain = model.frees("data.gain");
  const double agreement = gain ? std::abs(r) : r;
  const Alignment best = best_alignment(data, start, gain ? Sign::free : Sign::kept);
  const double best_agreement = std::abs(best.correlation);
  std::vector<std::string> warnings;
  if (!gain) {
    require_kept_sign(best, best_alignment(data, start, Sign::free),
                      correlation(data.values, predict_shifted(data, start, 0)));
    if (size > other_size * start_size || other_size * size < start_size) {
      const std::string text = fmt::format(
          "the data are {:.3g} times the size of the start's signal ({:.3g} {} and {:.3g} {} rms "
          "about the mean)",
          size / start_size, size, data.unit, start_size, data.unit);
      const std::string remedy =
          "check the unit in the header and the gain of the amplifier, start "
          "from values that give such a size, or free data.gain";
      if (size > too_large * start_size || size < too_small * start_size) {
        throw UserError(text + "\n  = " + remedy);
      }
      warnings.push_back("At the start " + text + ": " + remedy + ".");
    }
  }
  const bool shift_helps = best_agreement > alike && best_agreement > agreement + clearly;
  if (!model.frees("data.time_shift") && shift_helps) {
    const std::string text = shift_text(data, best, r, adjustment.time_shift);
    if (agreement < hopeless && best_agreement > sure && !frees_motion(model)) {
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

} // namespace ionskin::study
