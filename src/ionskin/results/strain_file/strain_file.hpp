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
//   slider_x         [time], slider frame only [m]
//   slider_y         [time], optional; mid-width without it [m]
//   event_time       optional, some of the entries of time [s]
// Attributes of the root or group: format = "ionskin-strain", version = 1, measure, frame = "skin"
// or "slider".

/// Writes a history; repeated fields are compressed once.
void write_strain(Hdf5File& file, const std::string& group, const history::CoreHistory& history);

/// Writes a strain file with the layout at its root, atomically.
void write_strain_file(const std::filesystem::path& path, const history::CoreHistory& history);

/// Reads and checks a strain file or the strain of a results.h5. Equal fields are shared. Without
/// event_time the events are found by `detect_events`.
/// @param skin whose core the history must cover
/// Throws UserError saying what is wrong, where, the actual value and the remedy.
/// @param group of a results.h5 that holds the strain; empty: /strain, or the root of a strain file
history::CoreHistory read_strain_file(const std::filesystem::path& path, const Skin& skin,
                                      const std::string& group = "");
history::CoreHistory read_strain_file(const ForeignHdf5File& file, const Skin& skin,
                                      const std::string& group = "");

} // namespace ionskin::results
