// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"

namespace ionskin::study {

/// Estimate of the rounding error in a charge of the electrodes [C]: 5e-11 of the largest charge
/// that the strain history can move.
/// @param history strain history that drives the ions
double charge_rounding(const Case& input, const history::CoreHistory& history);

} // namespace ionskin::study
