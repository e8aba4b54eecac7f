// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/results/output_folder.hpp"

#include <vector>

namespace ionskin::results {

/// Writes every snapshot as fields_0000.vtu, fields_0001.vtu, ... with fields.pvd, which gives them
/// their instants, into the subfolder `fields`. Point data: concentration [mol/m3], potential
/// [V] and shear [1], constant over each column and linear in z as they are computed.
/// @param core_bottom height of the core's lower face in the skin's frame [m]
/// Throws UserError when a file cannot be written.
void write_fields(OutputFolder& folder, const electrochemistry::TransportGrid& grid,
                  double core_bottom, const std::vector<electrochemistry::IonSnapshot>& snapshots);

} // namespace ionskin::results
