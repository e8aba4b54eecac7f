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

/// Writes the fields of Study 2 in the core, one file per snapshot: fields_0000.vtu,
/// fields_0001.vtu, ... Point data are concentration [mol/m3], potential [V] and shear [1],
/// constant over each lateral column and linear in z, as in the discretisation.
/// @param core_bottom height of the core's lower face above the base of the skin [m]
void write_fields(OutputFolder& folder, const electrochemistry::TransportGrid& grid,
                  double core_bottom, const std::vector<electrochemistry::IonSnapshot>& snapshots);

/// Writes the deformed skin and one slider at one instant, as three files. layers_0000.vtu has
/// displacement [m] at points, and per cell the index of the layer (0 at the bottom), stress and
/// von Mises stress [Pa]. contact_0000.vtu has traction [Pa], pressure [Pa] and displacement [m] of
/// the contact cells, drawn on the undeformed top face. slider_0000.vtu is the underside of the
/// slider. If a case has several sliders, call it for each: its layers then show the effect of the
/// forces of that slider only.
/// @param suffix of the slider ("_2" for the second), as in "layers_2_0000.vtu"
/// @param instant index of the instant in the names, from 0
void write_skin(OutputFolder& folder, const Slider& slider, const std::string& suffix,
                std::size_t instant, const SkinSnapshot& snapshot);

/// Writes fields.pvd, the collection with which ParaView opens all of these files that exist.
/// Writes nothing if none exists.
/// @param instants times of the snapshots, ascending [s]
/// @param suffixes of all sliders
void write_collection(OutputFolder& folder, const std::vector<double>& instants,
                      const std::vector<std::string>& suffixes);

} // namespace ionskin::results
