// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"

namespace ionskin::study {

/// Error that rounding may leave in a charge of the electrodes: 5e-11 of the largest charge that
/// the history can move [C].
double charge_rounding(const Case& input, const history::CoreHistory& history);

} // namespace ionskin::study
