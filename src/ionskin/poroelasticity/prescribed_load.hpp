// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"

#include <vector>

namespace ionskin::poroelasticity {

/// The undrained pore pressure of a load that is uniform along the skin, of a checked case with
/// strain.source = "prescribed": one column, linear through the core, over strain.duration,
/// docs/model.md (24):
/// - pressure p, the strain along the skin held at 0 by the electrodes: p_u = p M_B/(M + M_B);
/// - compression d, held likewise: that of the pressure M d/h, to which comes what the mean of P
///   adds, docs/model.md (75);
/// - curvature k about the middle of the core, with e_xx = k (z - h/2) and faces free of stress:
///   p_u = -M_B tr(e), tr(e) = (1 - 2 nu_u) e_xx of a strip with free sides, and that over
///   1 - nu_u between symmetry planes (nu_u: Poisson's ratio of the core, the undrained one).
history::CoreHistory prescribed_history(const Case& input);

/// Share of a prescribed load over time, linear between the samples.
struct LoadShares {
  std::vector<double> time;  ///< [s]
  std::vector<double> share; ///< of the whole load [1]
};
LoadShares load_shares(const StrainSource& strain);

} // namespace ionskin::poroelasticity
