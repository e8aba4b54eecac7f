// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/run/warnings.hpp"

#include "ionskin/base/percent.hpp"
#include "ionskin/circuits/circuit.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/laws/coupling/coupling_law.hpp"
#include "ionskin/poroelasticity/validity.hpp"
#include "ionskin/readout/metrics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace ionskin::study {
namespace {

// Limits above which the reader of the results is warned.
constexpr double linear_limit = 0.3;    // on k gamma h / (2 lambda) [1]
constexpr double depletion_limit = 0.1; // on the smallest c / c0 [1], which warns below it
constexpr double large_error = 0.2;     // on the reported relative error of a quantity that is read
constexpr std::size_t most_named = 3;   // number of quantities that a warning names, largest first
constexpr double pressure_limit = 1e6;  // on the mean pressure [Pa]; a fingertip has some 10 kPa
constexpr double cut_limit = 0.01; // on the distance of a taxel's edge from a column's, relative

void warn_about_common_current(const Case& input, const readout::SignalTable& signals,
                               std::vector<std::string>& warnings) {
  const auto& time = signals.column("time").values;
  const double common = readout::rms_of_step_means(time, signals.column("current_common").values);
  const double difference =
      readout::rms_of_step_means(time, signals.column("current_difference").values);
  if (!laws::coupling_law(input.coupling.law).traits.makes_net_charge || common <= difference) {
    return;
  }
  if (input.readout.is_cut()) {
    warnings.push_back(fmt::format(
        "The common part of the charges dominates in current_top_NAME of taxels.csv: an instrument "
        "between a {} reads current_circuit_NAME only. Compare that one with a measurement, or "
        "take a neutral law (coupling.law = \"column-neutral\").",
        input.readout.is_crossbar() ? "line and the ground" : "taxel and the bottom electrode"));
  } else if (!circuits::circuit_row(input.readout.circuit).holds_potential) {
    warnings.emplace_back(
        "The common part of the electrode currents dominates in current_top and current_bottom: a "
        "voltmeter between the electrodes reads voltage only. Compare that one with a measurement, "
        "or take a neutral law (coupling.law = \"column-neutral\").");
  } else {
    warnings.push_back(fmt::format(
        "The common part of the electrode currents dominates, {:.3g} times the difference: an "
        "ammeter between the electrodes reads current_difference only. Compare that one with a "
        "measurement, or take a neutral law (coupling.law = \"column-neutral\").",
        common / difference));
  }
}

void warn_about_water(const Case& input, const electrochemistry::IonSolution& ions,
                      std::vector<std::string>& warnings) {
  if (!laws::coupling_law(input.coupling.law).traits.moves_water) {
    return;
  }
  for (std::string& warning : poroelasticity::validity_warnings(input)) {
    warnings.push_back(std::move(warning));
  }
  const auto& drive = ions.water.largest_drive;
  const double largest = drive.empty() ? 0.0 : *std::max_element(drive.begin(), drive.end());
  if (largest > poroelasticity::largest_sound_drive) {
    warnings.push_back(fmt::format(
        "The drive g of the water on the cations reaches {:.3g} (thermal voltages over the "
        "valence): above {:.2g} the core's constants, taken at rest, no longer serve, and the "
        "voltages in water.csv, which are linear, are off. Press with less, or round sharp edges "
        "(slider.edge_radius).",
        largest, poroelasticity::largest_sound_drive));
  }
}

/// Warns where an edge of a taxel cuts a column of the transport grid, whose charge is then divided
/// by area.
void warn_about_cut_columns(const std::vector<Taxel>& taxels,
                            const electrochemistry::TransportGrid& grid,
                            std::vector<std::string>& warnings) {
  double worst = 0;
  const Taxel* of = nullptr;
  for (const Taxel& taxel : taxels) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const std::vector<double>& borders = axis == 0 ? grid.x_edges : grid.y_edges;
      for (const double edge : {taxel.lower[axis], taxel.upper[axis]}) {
        double nearest = std::abs(edge - borders.front());
        for (const double border : borders) {
          nearest = std::min(nearest, std::abs(edge - border));
        }
        const double share = nearest / (taxel.upper[axis] - taxel.lower[axis]);
        if (borders.size() > 2 && share > worst) {
          worst = share;
          of = &taxel;
        }
      }
    }
  }
  if (worst > cut_limit) {
    warnings.push_back(fmt::format(
        "An edge of the taxel {} lies inside a column of the transport grid, {} of the taxel's "
        "side "
        "from the column's border: the charge of that column is shared by area. Place the edges of "
        "taxels at equal parts of the skin, or raise numerics.mesh_refinement.",
        of->name, base::percent(worst)));
  }
}

// Metrics whose large errors are warned of: readings of a scale and of an instrument between the
// electrodes. Errors of other metrics are shown in the report and by `ionskin compare` only.
constexpr std::array always_read{
    "normal_force_slide",        "tangential_force_slide", "mean_shear_slide",
    "peak_mean_shear",           "peak_voltage",           "rms_voltage",
    "peak_open_circuit_voltage", "peak_taxel_voltage",     "peak_sampled_taxel_current",
    "peak_amplifier_current"};
// Metrics whose large errors are warned of only if the circuit keeps the electrodes at one
// potential; otherwise little current flows.
constexpr std::array read_as_current{"peak_sampled_current_difference", "rms_current_difference",
                                     "tail_current_difference"};

bool is_read(const Case& input, const std::string& metric) {
  return std::ranges::find(always_read, metric) != always_read.end() ||
         (circuits::circuit_row(input.readout.circuit).holds_potential &&
          std::ranges::find(read_as_current, metric) != read_as_current.end());
}

void warn_about_large_errors(const Case& input, const ErrorEstimate& errors,
                             std::vector<std::string>& warnings) {
  std::vector<std::pair<double, std::string>> large;
  for (const auto& [name, error] : errors.relative) {
    if (error > large_error && is_read(input, name) && !errors.not_converging.contains(name)) {
      large.emplace_back(error, name);
    }
  }
  if (large.empty()) {
    return;
  }
  std::ranges::sort(large, std::greater<>{});
  std::string named;
  for (std::size_t i = 0; i < std::min(large.size(), most_named); ++i) {
    named +=
        fmt::format("{}{} ({})", i > 0 ? ", " : "", large[i].second, base::percent(large[i].first));
  }
  warnings.push_back(fmt::format(
      "The stated error exceeds {:.0f} % for {}{}. Choose a finer numerics.preset, or raise "
      "numerics.mesh_refinement.",
      100 * large_error, named,
      large.size() > most_named ? fmt::format(" and {} more", large.size() - most_named) : ""));
}

void warn_about_missing_errors(const ErrorEstimate& errors, std::vector<std::string>& warnings) {
  std::vector<std::string> names;
  for (const auto& [name, reason] : errors.not_estimated) {
    if (reason == not_a_number) {
      names.push_back(name);
    }
  }
  if (!names.empty()) {
    warnings.push_back(fmt::format("The error of {} is not estimated: a coarser solution gives no "
                                   "number for it.",
                                   fmt::join(names, ", ")));
  }
}

/// Warns where the coupling coefficient k makes the response nonlinear, or depletes the cations at
/// an electrode.
void warn_about_strong_coupling(const Case& input, const electrochemistry::IonSolution& ions,
                                const readout::SignalTable& signals,
                                std::vector<std::string>& warnings) {
  const auto scales =
      electrochemistry::derive_scales(input.electrochemistry, input.skin.core_thickness());
  const auto& p99 = signals.column("p99_shear").values;
  const double shear = *std::max_element(p99.begin(), p99.end());
  const double strength = electrochemistry::nonlinearity(scales, input.coupling.coefficient, shear);
  if (strength > linear_limit) {
    warnings.push_back(fmt::format(
        "The response is nonlinear (k gamma h/(2 lambda) is {:.3g}, above {:.2g}): currents do not "
        "scale with k. Run each k that you compare, or press with less.",
        strength, linear_limit));
  }
  const double initial =
      input.electrochemistry.fixed_charge_concentration / input.electrochemistry.valence;
  const double least =
      *std::min_element(ions.min_concentration.begin(), ions.min_concentration.end()) / initial;
  if (least < depletion_limit) {
    warnings.push_back(fmt::format("Cations are depleted down to {:.3g} of their initial "
                                   "concentration at an electrode, where the transport model is "
                                   "at its limit. Press with less, or lower coupling.coefficient.",
                                   least));
  }
}

/// Warns where the double layers of both electrodes overlap.
void warn_about_thin_core(const Case& input, std::vector<std::string>& warnings) {
  constexpr double separate = 10; // Debye lengths; e^-5 of the potential of a wall in the middle
  const double thickness = input.skin.core_thickness(),
               length =
                   electrochemistry::derive_scales(input.electrochemistry, thickness).debye_length;
  if (thickness < separate * length) {
    warnings.push_back(fmt::format(
        "The core is only {:.3g} Debye lengths of {:.3g} um thick, so that the double layers of "
        "both electrodes overlap, and the scales of check --explain (capacitance, charging time) "
        "do "
        "not hold. Check the unit of the core's thickness and electrochemistry.permittivity.",
        thickness / length, length * 1e6));
  }
}

void warn_about_pressure(const Slider& slider, const SliderRecord& record,
                         std::vector<std::string>& warnings) {
  if (!record.normal_force.empty() && slider.sharp()) {
    const double force = *std::max_element(record.normal_force.begin(), record.normal_force.end());
    const double pressure = force / (slider.size[0] * slider.size[1]);
    if (pressure > pressure_limit) {
      warnings.push_back(fmt::format(
          "The slider presses with up to {:.3g} N ({:.3g} MPa on average; a finger "
          "presses with 1 to 10 N). For less set motion.preload to a force, such as "
          "\"2 N\"; the pressure under its sharp edges is not a result, round them with "
          "slider.edge_radius.",
          force, pressure / 1e6));
    }
  }
}

} // namespace

std::vector<std::string> mechanics_warnings(const Case& input, const MechanicsRecord& mechanics) {
  std::vector<std::string> warnings = mechanics.warnings;
  warn_about_pressure(input.slider, mechanics, warnings);
  for (std::size_t i = 0; i < mechanics.further_sliders.size(); ++i) {
    const SliderRecord& further = mechanics.further_sliders[i];
    warnings.insert(warnings.end(), further.warnings.begin(), further.warnings.end());
    warn_about_pressure(input.further_sliders[i].slider, further, warnings);
  }
  warnings.insert(warnings.end(), input.notes.begin(), input.notes.end());
  return warnings;
}

std::vector<std::string> collect_warnings(const Case& input, const MechanicsRecord& mechanics,
                                          const electrochemistry::IonSolution& ions,
                                          const readout::SignalTable& signals) {
  std::vector<std::string> warnings;
  warn_about_strong_coupling(input, ions, signals, warnings);
  warn_about_thin_core(input, warnings);
  warn_about_water(input, ions, warnings);
  warn_about_common_current(input, signals, warnings);
  for (std::string& warning : mechanics_warnings(input, mechanics)) {
    warnings.push_back(std::move(warning));
  }
  warn_about_cut_columns(input.readout.taxels, ions.grid, warnings);
  if (input.coupling.coefficient != 0) {
    warnings.push_back(fmt::format(
        "The coupling coefficient k = {:.4g} is not calibrated by any measurement, and sets the "
        "size of all currents. Fit it to one (ionskin fit), or compare shapes and ratios.",
        input.coupling.coefficient));
  }
  return warnings;
}

std::vector<std::string> error_warnings(const Case& input, const ErrorEstimate& errors) {
  std::vector<std::string> warnings;
  warn_about_large_errors(input, errors, warnings);
  warn_about_missing_errors(errors, warnings);
  return warnings;
}

} // namespace ionskin::study
