// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/metrics/slip_metrics.hpp"

#include "ionskin/base/value_at.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/readout/circuit.hpp"
#include "ionskin/readout/phases.hpp"
#include "ionskin/readout/slip_precursor.hpp"
#include "ionskin/study/metrics/charge_rounding.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace ionskin::study {
namespace {

using readout::Metric;
using readout::SlipOnset;

/// Multiple of the rounding error of a charge that a current has to move before its precursor is
/// evaluated: a smaller one would correlate by chance [1].
constexpr double far_above_rounding = 100;

/// Travel of the slider between two instants of the first cycle [m].
double way_between(const Case& input, double from, double to) {
  double way = 0;
  for (const MotionLeg& leg : motion_legs(input.motion, input.slider)) {
    const double begin = std::max(from, leg.begin), end = std::min(to, leg.end());
    if (end > begin) {
      way += leg.length() * (end - begin) / leg.duration;
    }
  }
  return way;
}

/// Noise from which a current has to stand out.
struct NoiseFloor {
  double charge = 0;  ///< error that rounding leaves in a charge [C]
  double reading = 0; ///< root mean square noise of a reading [A]
};

/// Share of the contact area that half a row of cells along the border of the sticking area takes
/// at the end of touchdown [1].
double cell_share(const MechanicsRecord& mechanics) {
  const auto found =
      std::ranges::find(mechanics.cell_errors, "stick_fraction_touchdown", &Metric::name);
  return found == mechanics.cell_errors.end() ? 0.0 : found->value;
}

std::vector<double> common_charge(const readout::SignalTable& signals) {
  std::vector<double> common = signals.column("charge_top").values;
  const std::vector<double>& bottom = signals.column("charge_bottom").values;
  for (std::size_t row = 0; row < common.size(); ++row) {
    common[row] = 0.5 * (common[row] + bottom[row]);
  }
  return common;
}

void add_precursor(const std::string& current, const readout::SlipPrecursor& precursor,
                   const NoiseFloor& noise, std::vector<Metric>& metrics) {
  if (precursor.departure) {
    metrics.push_back({"precursor_current_" + current, *precursor.departure, "A"});
  }
  if (precursor.charge <= far_above_rounding * noise.charge) {
    return;
  }
  if (precursor.lead_time) {
    metrics.push_back({"precursor_lead_time_" + current, *precursor.lead_time, "s"});
    metrics.push_back(
        {"precursor_signal_to_noise_" + current, *precursor.departure / noise.reading, "1"});
  }
  if (precursor.correlation) {
    metrics.push_back({"precursor_correlation_" + current, *precursor.correlation, "1"});
  }
}

} // namespace

std::optional<SlipOnset> slip_onset(const Case& input, const MechanicsRecord& mechanics) {
  const MotionLeg slide = whole_slide(motion_legs(input.motion, input.slider));
  if (!mechanics.has_contact() || !slide.slides()) {
    return std::nullopt;
  }
  return readout::find_slip_onset(mechanics.history.time, mechanics.contact_area,
                                  mechanics.stick_share, {slide.begin, slide.end()});
}

std::vector<Metric> slip_metrics(const Case& input, const MechanicsRecord& mechanics) {
  const std::optional<SlipOnset> onset = slip_onset(input, mechanics);
  if (!onset) {
    return {};
  }
  const auto force = [&](const std::vector<double>& of) {
    return base::value_at(mechanics.history.time, of, onset->micro_slip);
  };
  const double normal = force(mechanics.normal_force);
  std::vector<Metric> metrics{
      {"micro_slip_time", onset->micro_slip - onset->begin, "s"},
      {"micro_slip_force_ratio",
       normal > 0 ? std::abs(force(mechanics.tangential_force)) / normal : 0.0, "1"}};
  if (onset->full_slip) {
    const double full = *onset->full_slip;
    metrics.push_back({"full_slip_time", full - onset->begin, "s"});
    metrics.push_back({"slip_lead_time", full - onset->micro_slip, "s"});
    metrics.push_back({"slip_lead_travel", way_between(input, onset->micro_slip, full), "m"});
  }
  return metrics;
}

std::vector<Metric> slip_least_errors(const Case& input, const MechanicsRecord& mechanics) {
  const std::optional<SlipOnset> onset = slip_onset(input, mechanics);
  if (!onset) {
    return {};
  }
  const double share = cell_share(mechanics) / readout::micro_slip_share;
  const double micro =
      std::max(0.5 * onset->micro_slip_step, share * (onset->micro_slip - onset->begin));
  std::vector<Metric> errors{{"micro_slip_time", micro, "s"}};
  for (const Metric& metric : slip_metrics(input, mechanics)) {
    if (metric.name == "micro_slip_force_ratio") {
      errors.push_back({metric.name, share * metric.value, metric.unit});
    }
  }
  if (onset->full_slip) {
    const double full = 0.5 * onset->full_slip_step, lead = *onset->full_slip - onset->micro_slip;
    const double way = way_between(input, onset->micro_slip, *onset->full_slip);
    errors.push_back({"full_slip_time", full, "s"});
    errors.push_back({"slip_lead_time", micro + full, "s"});
    errors.push_back({"slip_lead_travel", way * (micro + full) / lead, "m"});
    for (const char* current : {"difference", "common"}) {
      errors.push_back({std::string("precursor_lead_time_") + current, full, "s"});
    }
  }
  return errors;
}

std::vector<Metric> precursor_metrics(const Case& input, const MechanicsRecord& mechanics,
                                      const readout::SignalTable& signals, double sample_noise) {
  const std::optional<SlipOnset> onset = slip_onset(input, mechanics);
  if (!onset || !onset->full_slip) {
    return {};
  }
  const double rounding = charge_rounding(input, mechanics.history);
  const NoiseFloor noise{rounding,
                         std::max(sample_noise, rounding / input.readout.sample_interval)};
  std::vector<Metric> metrics{{"precursor_noise_floor", noise.reading, "A"}};
  const auto add = [&](const std::string& current, const std::vector<double>& charge) {
    add_precursor(current,
                  readout::slip_precursor(signals.column("time").values, charge,
                                          signals.column("stick_share").values, *onset,
                                          input.readout.sample_interval, noise.reading),
                  noise, metrics);
  };
  add("difference", readout::charge_difference(signals.column("charge_top").values,
                                               signals.column("charge_bottom").values));
  add("common", common_charge(signals));
  return metrics;
}

} // namespace ionskin::study
