// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"

#include <vector>

namespace ionskin::poroelasticity {

/// Makes the history of the undrained pore pressure p_u [Pa] under a load that is uniform along the
/// skin: one lateral column, linear through the core, over `strain.duration`, docs/model.md (24).
/// The load is one of three:
/// - pressure p, with the strain along the skin held at 0 by the electrodes: p_u = p M_B/(M + M_B);
/// - compression d, with the strain along the skin held at 0: p_u as for the pressure M d/h; the
///   contribution of the mean of P, docs/model.md (75), is not included;
/// - curvature k about the middle of the core, with e_xx = k (z - h/2) and faces free of stress:
///   p_u = -M_B tr(e), where tr(e) = (1 - 2 nu_u) e_xx for a strip with free sides, and
///   (1 - 2 nu_u)/(1 - nu_u) e_xx between symmetry planes (nu_u: undrained Poisson's ratio).
/// @param input checked case with `strain.source = "prescribed"`
history::CoreHistory prescribed_history(const Case& input);

/// Waveform of a prescribed load: factor of the whole load over time, linear between samples.
struct LoadShares {
  std::vector<double> time;  ///< [s], ascending from 0
  std::vector<double> share; ///< factor of the whole load at each time [1]
};
/// Samples the waveform of a prescribed load over its duration.
LoadShares load_shares(const StrainSource& strain);

} // namespace ionskin::poroelasticity
