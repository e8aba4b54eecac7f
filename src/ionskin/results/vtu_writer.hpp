// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/results/output_folder.hpp"
#include "ionskin/results/skin_snapshot.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace ionskin::results {

// Files for ParaView in the subfolder `fields`. Throw UserError when a file cannot be written.

/// Writes the fields that Study 2 kept, as fields_0000.vtu, fields_0001.vtu, ... Point data:
/// concentration [mol/m3], potential [V] and shear [1], constant over each column and linear in z
/// as they are computed.
/// @param core_bottom height of the core's lower face in the skin's frame [m]
void write_fields(OutputFolder& folder, const electrochemistry::TransportGrid& grid,
                  double core_bottom, const std::vector<electrochemistry::IonSnapshot>& snapshots);

/// Skin and slider, as layers_0000.vtu with displacement [m] at points, and in cells the number of
/// the layer, counted from 0 at the bottom, and stress [Pa]; contact_0000.vtu with traction,
/// pressure [Pa] and displacement [m] of the cells on the undeformed top face; slider_0000.vtu. Of
/// several sliders each has files of its own, and layers hold what its forces alone do.
/// @param suffix of the slider, behind the first word of each name
/// @param instant its number from 0
void write_skin(OutputFolder& folder, const Slider& slider, const std::string& suffix,
                std::size_t instant, const SkinSnapshot& snapshot);

/// fields.pvd, which opens all of these that are there.
/// @param instants ascending [s]
/// @param suffixes of the sliders
void write_collection(OutputFolder& folder, const std::vector<double>& instants,
                      const std::vector<std::string>& suffixes);

} // namespace ionskin::results
