// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/signals.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ionskin::readout {

/// One named quantity of summary.json.
struct Metric {
  std::string name;
  double value = 0;
  std::string unit;
};

/// Largest magnitude; empty entries (NaN) are passed over.
double peak_magnitude(const std::vector<double>& values);
/// Time-weighted root mean square of a quantity that is linear between the rows.
double rms_linear(const std::vector<double>& time, const std::vector<double>& values);
/// Time-weighted root mean square of means over the steps that end at each row.
double rms_of_step_means(const std::vector<double>& time, const std::vector<double>& means);
/// Time mean of a quantity that is linear between the rows.
double time_mean(const std::vector<double>& time, const std::vector<double>& values);

/// Instants at which figures named `*_touchdown` and `*_slide` are taken [s].
struct NamedInstants {
  double touchdown = 0, slide = 0;
};

/// Everything summary.json says about the signals of a run. `*_touchdown` stands for the end of the
/// first touchdown and `*_slide` for the middle of the first slide.
/// @param instants empty in runs from a strain file: the quantities that need them are left out
std::vector<Metric> signal_metrics(const SignalTable& signals, const SignalTable& sampled,
                                   const std::optional<NamedInstants>& instants);

/// Worst violation of Gauss' law, docs/model.md (26), over all rows: |Q_top + Q_bottom - expected|
/// / scale.
/// @param charge_top, charge_bottom from Poisson's residual at each wall [C]
/// @param expected total charge: F c0 k times the integral of gamma under `fixed-charge`, 0 under
/// the
///        neutral laws [C]
/// @param scale largest F c0 |k| times the integral of |gamma| over the run [C]; with a scale of 0
///        the error is 0 when the violation is, and infinite otherwise
double charge_identity_error(const std::vector<double>& charge_top,
                             const std::vector<double>& charge_bottom,
                             const std::vector<double>& expected, double scale);

} // namespace ionskin::readout
