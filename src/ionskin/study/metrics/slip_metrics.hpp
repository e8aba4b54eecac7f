// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/readout/metrics.hpp"
#include "ionskin/readout/signals.hpp"
#include "ionskin/readout/slip_onset.hpp"
#include "ionskin/study/store/mechanics_record.hpp"

#include <optional>
#include <vector>

namespace ionskin::study {

/// Onset of slip in the first slide; empty without a slide or a contact, or where nothing sticks.
std::optional<readout::SlipOnset> slip_onset(const Case& input, const MechanicsRecord& mechanics);

/// Metrics of the onset of slip in the first slide: time from the start of the slide to the first
/// micro-slip and to full slip [s], lead of the first before the second in time [s] and in travel
/// of the slider [m], and ratio of tangential to normal force at the first micro-slip [1]. Metrics
/// that the slide does not reach are left out.
std::vector<readout::Metric> slip_metrics(const Case& input, const MechanicsRecord& mechanics);

/// Least errors of the metrics of the onset of slip, by the metric's name and in its unit: half the
/// step of the path in which an instant lies; for the first micro-slip also half a row of cells
/// along the border of the sticking area, relative to the loss of sticking area that defines this
/// instant (`readout::micro_slip_share`).
std::vector<readout::Metric> slip_least_errors(const Case& input, const MechanicsRecord& mechanics);

/// Metrics of the precursor of slip, for the difference and the common current before full slip
/// (readout/slip_precursor.hpp), and of the noise from which it has to stand out.
/// @param signals the resolved table with charges
/// @param sample_noise root mean square noise of a reading, of skin and instrument [A]
std::vector<readout::Metric> precursor_metrics(const Case& input, const MechanicsRecord& mechanics,
                                               const readout::SignalTable& signals,
                                               double sample_noise);

} // namespace ionskin::study
