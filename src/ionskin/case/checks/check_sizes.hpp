// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

namespace ionskin {

/// Largest number of times in a run at which a scan switches to the next row.
inline constexpr double most_scan_switches = 20'000;

/// Checks that a case does not exceed memory and disk: numbers of samples, instants of fields, legs
/// of the motion, and switches of a scan.
/// @param problems collects mistakes
void check_sizes(const CaseDocument& document, Problems& problems);

/// Checks the number of samples of a run with a strain file, whose duration is known only when the
/// file is read.
/// @param duration of the run [s]
/// Throws UserError when the sampling interval is too short for this duration.
void require_sampling(const Readout& readout, double duration);

} // namespace ionskin
