// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/history/core_history.hpp"

#include <optional>
#include <string>

namespace ionskin::electrochemistry {

/// Estimates from below the potential between core and electrodes that a net fixed charge drives
/// once the ions have spread as evenly as they can [V]. Fixed charge in excess of the ions by a
/// mean share e leaves a depleted layer of thickness d = e h / (2 (1 + e)) at each electrode,
///   phi = F c0 (1 + e) d^2 / (2 eps).
/// 0 for e <= 0, where ions accumulate instead. Any uneven distribution drives more, because phi is
/// convex in e.
/// @param excess e, mean over the core of cf / c0 - 1 [1]
double depletion_potential(const DerivedScales& scales, double excess);

/// Explains why a case has no meaningful solution, in words for the user; nothing where no reason
/// is found. Under `fixed-charge` in a core of many Debye lengths the net charge depletes the
/// electrodes by so much voltage that the concentration there, exp(-phi / V_T), underflows.
/// @param mean_shear largest mean of gamma over the core [1]
std::optional<std::string> no_sane_solution(const Case& input, double mean_shear);

/// Remedy for the user, in messages that report `no_sane_solution`.
std::string no_sane_solution_remedy();

/// Checks the net charge under a strain history. Throws SolverError when `no_sane_solution` finds a
/// reason.
void check_net_charge(const Case& input, const history::CoreHistory& history);

} // namespace ionskin::electrochemistry
