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

/// Onset of the first slide; nothing without a slide, or where nothing sticks.
std::optional<readout::SlipOnset> slip_onset(const Case& input, const MechanicsRecord& mechanics);

/// Instants of the first micro-slip and of full slip since the slide began, the lead between them
/// in time and way of the slider, and the ratio of the forces at the first micro-slip. Only what
/// the slide comes to.
std::vector<readout::Metric> slip_metrics(const Case& input, const MechanicsRecord& mechanics);

/// Least errors of these by name: half the step of the path in which an instant lies, and of the
/// first micro-slip what half a row of cells along the border of what sticks is beside the share
/// that it is derived from.
std::vector<readout::Metric> slip_least_errors(const Case& input, const MechanicsRecord& mechanics);

/// Metrics of the difference and the common current before full slip (readout/slip_precursor.hpp),
/// and of the noise that they are distinguished from.
/// @param signals the resolved table with charges
/// @param sample_noise rms of a reading, of skin and instrument [A]
std::vector<readout::Metric> precursor_metrics(const Case& input, const MechanicsRecord& mechanics,
                                               const readout::SignalTable& signals,
                                               double sample_noise);

} // namespace ionskin::study
