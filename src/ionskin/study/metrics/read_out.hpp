// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/readout/metrics.hpp"
#include "ionskin/readout/signals.hpp"
#include "ionskin/study/store/mechanics_record.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ionskin::study {

/// Signals over time and scalar metrics of a run. Made by `read_out` and the functions beside it.
struct Signals {
  /// Resolved signals, one row per time step, and currents sampled at the readout interval.
  readout::SignalTable resolved, sampled;
  /// Charges, currents and voltages of the taxels of a segmented electrode; empty without taxels.
  std::optional<readout::SignalTable> taxels;
  /// Voltage and current at the terminals, or the readings of an instrument there; empty where the
  /// terminals are shorted.
  std::optional<readout::SignalTable> circuit;
  /// Pressures and flows of water; empty under laws that move no water.
  std::optional<readout::SignalTable> water;
  /// Tables `taxels` and `circuit` as sampled at the readout interval.
  std::optional<readout::SignalTable> sampled_taxels, sampled_circuit;
  std::vector<std::string> warnings; ///< warnings of the instruments, one sentence each
  /// Scalar results, as in summary.json.
  std::vector<readout::Metric> metrics;
};

/// Makes the signals and metrics of a run of both studies, one row per time step of the ion
/// transport.
Signals read_out(const Case& input, const MechanicsRecord& mechanics,
                 const electrochemistry::IonSolution& ions, int threads);

/// Makes the signals, without metrics, of a run whose ion transport ended early; one row per time
/// step up to there.
Signals read_out_rows(const Case& input, const MechanicsRecord& mechanics,
                      const electrochemistry::IonSolution& ions, int threads);

/// Makes the signals and metrics of a run of Study 1 without ion transport, one row per sample of
/// the strain history; charges and currents are NaN.
Signals read_out_mechanics(const Case& input, const MechanicsRecord& mechanics, int threads);

/// Makes the signals, without metrics, of a contact that ended early; one row per sample of the
/// strain history up to there.
Signals read_out_mechanics_rows(const Case& input, const MechanicsRecord& mechanics, int threads);

/// Metrics that are audited: those of the signals and, of a solved contact, the largest 99th
/// percentile of the shear over time, since the model takes strains as small. A given strain is not
/// audited for its size.
std::vector<readout::Metric> audited_metrics(const MechanicsRecord& mechanics,
                                             const Signals& signals);

} // namespace ionskin::study
