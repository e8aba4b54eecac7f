// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"
#include "ionskin/results/hdf5/foreign_hdf5_file.hpp"
#include "ionskin/results/hdf5/hdf5_file.hpp"

#include <filesystem>
#include <string>

namespace ionskin::results {

// The layout of a strain file, at the root of a file or inside the group /strain of results.h5:
//   grid/x, grid/y   cell edges [m]
//   grid/z           nodes from 0 at the bottom of the core [m]
//   time             [s]
//   gamma            [time, z, y, x], attribute unit = "1"
//   channels/NAME    [time, z, y, x], attribute unit; in version 2, any channel by its name
//   slider_x         [time], slider frame only [m]
//   slider_y         [time], optional; mid-width without it [m]
//   event_time       optional, some of the entries of time [s]
// Attributes of the root or group: format = "ionskin-strain", version = 1 (shear only, in gamma) or
// 2 (channels), measure, frame = "skin" or "slider".

/// Writes a strain history into a group of an open file. Fields that several samples share are
/// compressed only once.
/// @param group path of the group; "/" for the root of the file
void write_strain(Hdf5File& file, const std::string& group, const history::CoreHistory& history);

/// Writes a strain history as a strain file, with the layout above at its root, atomically.
/// Throws UserError when the file cannot be written.
void write_strain_file(const std::filesystem::path& path, const history::CoreHistory& history);

/// Reads and checks the strain history in a strain file or in a results.h5. Samples with identical
/// fields share one field in memory. If the file has no event_time, `detect_events` finds the
/// events.
/// @param skin skin whose core the grid must cover
/// @param group group that holds the strain; empty: /strain if the file has one, else the root
/// Throws UserError saying what is wrong, where, the actual value and the remedy.
history::CoreHistory read_strain_file(const std::filesystem::path& path, const Skin& skin,
                                      const std::string& group = "");
history::CoreHistory read_strain_file(const ForeignHdf5File& file, const Skin& skin,
                                      const std::string& group = "");

} // namespace ionskin::results
