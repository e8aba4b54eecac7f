// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/signals.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ionskin::readout {

/// Named quantity of summary.json, such as a peak or a mean.
struct Metric {
  std::string name;
  double value = 0;
  std::string unit;
};

/// Largest magnitude of some values, NaN ignored; 0 if there is none.
double peak_magnitude(const std::vector<double>& values);
/// Root mean square over time of a quantity that is linear between the rows; 0 for fewer than two
/// rows.
/// @param time [row] [s]
/// @param values [row]
double rms_linear(const std::vector<double>& time, const std::vector<double>& values);
/// Root mean square over time of a quantity that is given as means over the steps that end at each
/// row; 0 for fewer than two rows.
/// @param time [row] [s]
/// @param means [row]
double rms_of_step_means(const std::vector<double>& time, const std::vector<double>& means);
/// Mean over time of a quantity that is linear between the rows; 0 for fewer than two rows.
/// @param time [row] [s]
/// @param values [row]
double time_mean(const std::vector<double>& time, const std::vector<double>& values);

/// Instants at which the quantities of summary.json named `*_touchdown` and `*_slide` are taken
/// [s].
struct NamedInstants {
  double touchdown = 0, slide = 0;
};

/// Computes the quantities of summary.json that follow from the signals of a run. `*_touchdown` is
/// taken at the end of the first touchdown, `*_slide` in the middle of the first slide.
/// @param signals resolved signals, as signals.csv has them
/// @param sampled currents over the readout intervals, from `sample_currents`
/// @param instants empty in runs from a strain file, for which `*_touchdown` and `*_slide` are left
/// out
std::vector<Metric> signal_metrics(const SignalTable& signals, const SignalTable& sampled,
                                   const std::optional<NamedInstants>& instants);

/// Largest violation of Gauss' law, docs/model.md (26), over all rows: |Q_top + Q_bottom -
/// expected| / scale [1].
/// @param charge_top, charge_bottom from Poisson's residual at each wall [row] [C]
/// @param expected total charge: F c0 k times the integral of gamma under `fixed-charge`, 0 under
/// the neutral laws [row] [C]
/// @param scale largest F c0 |k| times the integral of |gamma| over the run [C]. If it is 0, the
/// result is 0 without a violation and infinite otherwise
double charge_identity_error(const std::vector<double>& charge_top,
                             const std::vector<double>& charge_bottom,
                             const std::vector<double>& expected, double scale);

} // namespace ionskin::readout
