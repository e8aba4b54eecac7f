// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/errors/metric_neighbours.hpp"

#include "ionskin/case/case.hpp"
#include "ionskin/readout/slider_suffix.hpp"
#include "ionskin/study/errors/error_parts.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace ionskin::study {
namespace {

/// Signals related to metrics: a metric whose name contains the first text is related to the signal
/// of the second; the first match counts.
constexpr std::array<std::pair<std::string_view, std::string_view>, 31> signal_of{{
    {"slip_time", "stick_share"},
    {"slip_lead", "stick_share"},
    {"slip_force_ratio", "stick_share"},
    {"precursor_lead_time", "stick_share"},
    {"open_circuit_voltage", "open_circuit_voltage"},
    {"streaming_voltage", "streaming_voltage"},
    {"dilution_voltage", "dilution_voltage"},
    {"streaming_share", "open_circuit_voltage"},
    {"pressure_difference", "pressure_difference"},
    {"pressure_asymmetry", "pressure_difference"},
    {"peak_pore_pressure", "largest_pore_pressure"},
    {"peak_drive", "largest_drive"},
    {"current_top", "current_top"},
    {"current_bottom", "current_bottom"},
    {"current_difference", "current_difference"},
    {"current_common", "current_common"},
    {"signal_to_noise", "current_difference"},
    {"amplifier", "current_difference"},
    {"charge_difference", "charge_top"},
    {"charge_top", "charge_top"},
    {"charge_bottom", "charge_bottom"},
    {"voltage", "voltage"},
    {"tangential_force", "tangential_force"},
    {"normal_force", "normal_force"},
    {"_work", "tangential_force"},
    {"first_moment", "shear_first_moment"},
    {"p99_shear", "p99_shear"},
    {"p95_shear", "rms_shear"},
    {"element_max_shear", "p99_shear"},
    {"electrode_membrane_stress", "p99_shear"},
    {"nonlinearity", "p99_shear"},
}};

/// Texts in the names of metrics and signals that depend on the edges of the contact.
constexpr std::array<std::string_view, 11> made_at_edges{
    "first_moment",    "p95_shear",     "p99_shear",    "element_max",
    "membrane_stress", "_work",         "nonlinearity", "contact_area",
    "mean_pressure",   "peak_pressure", "stick"};

struct Neighbours {
  std::string_view metric;
  std::vector<std::string> others;
};

/// Metrics with related errors: those at one position and instant, and the two upper percentiles of
/// the shear. The largest shear is not related, as it does not converge under sharp edges.
const std::array<Neighbours, 9> neighbours{{
    {"contact_area_slide", {"mean_pressure_slide"}},
    {"mean_pressure_slide", {"contact_area_slide"}},
    {"peak_pressure_slide", {"mean_pressure_slide"}},
    {"slider_strain_slide", {"contact_area_slide"}},
    {"external_work", {"friction_work"}},
    {"friction_work", {"external_work"}},
    {"p95_shear_slide", {"p99_shear_slide"}},
    {"p99_shear_slide", {"p95_shear_slide"}},
    {"nonlinearity", {"p95_shear_slide"}},
}};

/// Splits the name of a further slider's metric into the name of the first slider's metric and the
/// suffix; the suffix is empty for other metrics.
std::pair<std::string, std::string> of_slider(const std::string& metric) {
  for (std::size_t i = 1; i < most_sliders; ++i) {
    const std::string suffix = readout::slider_suffix(i);
    if (metric.ends_with(suffix)) {
      return {metric.substr(0, metric.size() - suffix.size()), suffix};
    }
  }
  return {metric, ""};
}

bool is_of_slider(const std::string& signal) {
  return signal == "normal_force" || signal == "tangential_force" || signal == "stick_share";
}

} // namespace

bool is_audit(const std::string& metric) {
  return metric.ends_with("_residual") || metric.ends_with("_error") ||
         metric.ends_with("_noise_floor") || metric.starts_with("sample_noise");
}

bool hangs_on_edges(const std::string& quantity) {
  return std::ranges::any_of(made_at_edges, [&](const std::string_view name) {
    return quantity.find(name) != std::string::npos;
  });
}

std::vector<std::string> related_signals(const std::string& metric) {
  if (const auto [own, suffix] = of_slider(metric); !suffix.empty()) {
    std::vector<std::string> signals = related_signals(own);
    for (std::string& signal : signals) {
      signal += is_of_slider(signal) ? suffix : "";
    }
    return signals;
  }
  const auto found = std::ranges::find_if(
      signal_of, [&](const auto& entry) { return metric.find(entry.first) != std::string::npos; });
  if (found != signal_of.end()) {
    return {std::string(found->second)};
  }
  std::vector<std::string> signals = leading_signals(metric);
  signals.insert(signals.begin(), "mean_shear");
  return signals;
}

// In the slide the mean shear is the tangential force over the area of the skin and the modulus of
// the core, however the contact spreads the force; two meshes may still agree in it by chance.
std::vector<std::string> leading_signals(const std::string& signal) {
  return signal.find("mean_shear") == std::string::npos ? std::vector<std::string>{}
                                                        : std::vector<std::string>{"normal_force"};
}

std::vector<std::string> related_metrics(const std::string& metric) {
  if (const auto [own, suffix] = of_slider(metric); !suffix.empty()) {
    std::vector<std::string> metrics = related_metrics(own);
    for (std::string& one : metrics) {
      one += suffix;
    }
    return metrics;
  }
  const auto found = std::ranges::find(neighbours, metric, &Neighbours::metric);
  return found == neighbours.end() ? std::vector<std::string>{} : found->others;
}

} // namespace ionskin::study
