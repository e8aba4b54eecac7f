// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/study/metrics/read_out.hpp"
#include "ionskin/study/store/mechanics_record.hpp"

namespace ionskin::study {

/// Adds the noise of a reading of the taxel, or the line of a crossbar, with the largest signal.
/// Voltages take precedence over currents. The current of the whole electrode is the sum of its
/// readings, whose noise adds up by squares; for a crossbar the sum over the columns.
void add_noise_of_taxel(const Case& input, const MechanicsRecord& mechanics,
                        const electrochemistry::IonSolution& ions, Signals& signals);

/// Adds the noise of a reading of the electrode, and the metrics of slip precursors that stand out
/// from it. `signals` has the readings of the electrode already.
void add_noise(const Case& input, const MechanicsRecord& mechanics,
               const electrochemistry::IonSolution& ions, Signals& signals);

} // namespace ionskin::study
