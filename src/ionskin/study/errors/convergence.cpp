// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/errors/convergence.hpp"

#include "ionskin/readout/metrics.hpp"
#include "ionskin/readout/slider_suffix.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ionskin::study {
namespace {

/// Metrics that are extremes at a point.
constexpr std::array extremes{
    "element_max_shear_slide", "electrode_membrane_stress", "peak_pressure_slide", "max_potential",
    "min_concentration_ratio", "peak_pore_pressure",        "peak_drive"};

/// Reported relative error above which an extreme cannot be distinguished from one that grows
/// without bound on finer meshes.
constexpr double most_of_extreme = 1.0 / 3.0;

/// Reported relative error above which not even the order of magnitude of a resolved peak is known.
constexpr double most_of_peak = 1.0;

/// True if a metric describes the onset of sliding.
bool is_of_onset(const std::string& metric) {
  return metric.starts_with("micro_slip_") || metric.starts_with("slip_lead_") ||
         metric.starts_with("full_slip_") || metric.starts_with("precursor_");
}

/// True if the largest magnitude stands in one row: the rows on both sides hold less than half of
/// it, so that it is the mean of a spike over one time step.
bool is_single_step(const std::vector<double>& current) {
  std::size_t peak = 0;
  for (std::size_t row = 1; row < current.size(); ++row) {
    if (std::abs(current[row]) > std::abs(current[peak])) {
      peak = row;
    }
  }
  const double half = 0.5 * std::abs(current[peak]);
  const bool before = peak == 0 || std::abs(current[peak - 1]) < half;
  const bool behind = peak + 1 == current.size() || std::abs(current[peak + 1]) < half;
  return half > 0 && before && behind;
}

} // namespace

std::map<std::string, std::string> not_converging(const MechanicsRecord& mechanics,
                                                  const Signals& signals,
                                                  const std::map<std::string, double>& stated) {
  std::map<std::string, std::string> reasons;
  const auto mark = [&](const std::string& name, const std::string& reason) {
    if (std::ranges::find(signals.metrics, name, &readout::Metric::name) != signals.metrics.end()) {
      reasons[name] = reason;
    }
  };
  const bool any_sharp = mechanics.sharp_edge ||
                         std::ranges::any_of(mechanics.further_sliders, &SliderRecord::sharp_edge);
  for (std::size_t i = 0; i <= mechanics.further_sliders.size(); ++i) {
    for (const char* extreme : extremes) {
      const std::string name = extreme + readout::slider_suffix(i);
      const auto error = stated.find(name);
      // Metrics without a suffix, with few exceptions, are those of the whole skin.
      if (i == 0 ? any_sharp : mechanics.further_sliders[i - 1].sharp_edge) {
        mark(name, "extreme under a sharp edge, where finer meshes raise stress and strain");
      } else if (error != stated.end() && error->second > most_of_extreme) {
        mark(name,
             "extreme that this mesh does not resolve: two meshes differ by more than a third");
      }
    }
  }
  for (const auto& [name, error] : stated) {
    if (is_of_onset(name) && error > most_of_extreme) {
      mark(name, "onset of sliding that this mesh does not resolve: its error is above a third");
    }
  }
  for (const char* name :
       {"current_top", "current_bottom", "current_difference", "current_common"}) {
    const std::string peak = std::string("peak_") + name;
    const auto error = stated.find(peak);
    if (is_single_step(signals.resolved.column(name).values)) {
      mark(peak, "spike shorter than the time step, which finer steps raise");
    } else if (error != stated.end() && error->second > most_of_peak) {
      mark(peak, "peak that this mesh does not resolve: its error is larger than the peak");
    }
  }
  return reasons;
}

} // namespace ionskin::study
