// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification_table.hpp"

#include <vector>

namespace ionskin::verification {

/// Row sets P1, P2, P7: a drained layer against Terzaghi, a pressure difference between sealed
/// walls, and conservation of sealed water.
std::vector<Row> consolidation_rows();
/// Row sets P3, P4: open-circuit voltage and short-circuit charge after a step of pressure, linear
/// through the thickness, against closed forms and the linear equations.
std::vector<Row> pressure_step_rows(const Options& options);
/// Row set P5: waves of pressure along the skin, odd and even through the thickness.
std::vector<Row> lateral_wave_rows(const Options& options);
/// Row sets P6, P7: loads that must give nothing, change the sign of the signal, or conserve ions
/// and water.
std::vector<Row> symmetry_rows(const Options& options);
/// Row set P8: loads of strain.source = "prescribed", a bent strip and a pressed core, against
/// closed forms.
std::vector<Row> prescribed_load_rows(const Options& options);
/// Row sets P11 to P13: a permeation cell, walls of a finite conductance, and a held compression,
/// against closed forms.
std::vector<Row> wall_rows(const Options& options);
/// Row set P14: a Maxwell solid whose water moves, bent and pressed, against Laplace transforms and
/// closed forms.
std::vector<Row> relaxation_rows(const Options& options);
/// Row set P9: water that a current drags through open walls and against sealed walls (Saxen's
/// relation from the side of the water).
std::vector<Row> saxen_rows(const Options& options);

/// Row set P10: the model of thin double layers against the full equations, under a bump of
/// pressure that moves along the skin.
std::vector<Row> thin_double_layer_rows(const Options& options);

} // namespace ionskin::verification
