// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification_table.hpp"

#include <vector>

namespace ionskin::verification {

/// P1, P2, P7: a drained layer against Terzaghi, a pressure difference between sealed walls; what
/// sealed water conserves.
std::vector<Row> consolidation_rows();
/// P3, P4: open-circuit voltage and short-circuit charge after a step of pressure through the
/// thickness, against closed forms and the linear equations.
std::vector<Row> pressure_step_rows(const Options& options);
/// P5: waves of pressure along the skin, odd and even through the thickness.
std::vector<Row> lateral_wave_rows(const Options& options);
/// P6, P7: what must vanish, change its sign or be conserved.
std::vector<Row> symmetry_rows(const Options& options);
/// P8: bench loads of strain.source = "prescribed", a bent strip and a pressed core, against closed
/// forms.
std::vector<Row> prescribed_load_rows(const Options& options);
/// P11 to P13: a permeation cell, walls of a finite conductance, a compression that is held,
/// against closed forms.
std::vector<Row> wall_rows(const Options& options);
/// P14: a Maxwell solid whose water moves, bent and pressed, against Laplace transforms and closed
/// forms.
std::vector<Row> relaxation_rows(const Options& options);
/// P9: water that a current drags, through open walls and against sealed ones: Saxen's relation
/// from the side of the water.
std::vector<Row> saxen_rows(const Options& options);

/// P10: thin double layers against the full equations under a bump of pressure that moves along.
std::vector<Row> thin_double_layer_rows(const Options& options);

} // namespace ionskin::verification
