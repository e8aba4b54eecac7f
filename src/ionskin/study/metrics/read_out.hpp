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

/// Signals of a run: every signal over time, the sampled currents, and the named figures.
struct Signals {
  readout::SignalTable resolved, sampled;
  std::optional<readout::SignalTable> taxels;  ///< of a segmented top electrode
  std::optional<readout::SignalTable> circuit; ///< at the terminals, unless they are shorted
  std::optional<readout::SignalTable> water;   ///< of a law that moves it
  /// Taxels and circuit as the instrument samples them.
  std::optional<readout::SignalTable> sampled_taxels, sampled_circuit;
  std::vector<std::string> warnings; ///< of the readout
  std::vector<readout::Metric> metrics;
};

/// Both studies, one row per time step of the ion transport.
Signals read_out(const Case& input, const MechanicsRecord& mechanics,
                 const electrochemistry::IonSolution& ions, int threads);

/// Signals of both studies without figures, for an ion transport that did not come to its end.
Signals read_out_rows(const Case& input, const MechanicsRecord& mechanics,
                      const electrochemistry::IonSolution& ions, int threads);

/// Study 1 alone, one row per sample of the strain history; charges and currents stay empty.
Signals read_out_mechanics(const Case& input, const MechanicsRecord& mechanics, int threads);

/// Signals of Study 1 alone without figures, for a contact that did not come to its end.
Signals read_out_mechanics_rows(const Case& input, const MechanicsRecord& mechanics, int threads);

/// Figures that are audited: those of the signals, and the largest shear of a contact, which takes
/// strains as small; those of a file are as they are.
std::vector<readout::Metric> audited_metrics(const MechanicsRecord& mechanics,
                                             const Signals& signals);

} // namespace ionskin::study
