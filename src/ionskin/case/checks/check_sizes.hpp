// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

namespace ionskin {

/// Most instants of a run at which a scan goes to the next row.
inline constexpr double most_scan_switches = 20'000;

/// Checks the counts of a case: readings, instants of fields, legs of the motion. Each is held in
/// memory and written to disk.
void check_sizes(const CaseDocument& document, Problems& problems);

/// Refuses a sampling interval that makes too many readings over a duration [s], or none. For
/// strains from a file, whose duration is not known before.
/// Throws UserError.
void require_sampling(const Readout& readout, double duration);

} // namespace ionskin
