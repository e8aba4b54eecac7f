// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace ionskin {

/// Most waypoints of one path, in a case or in a file.
inline constexpr std::size_t most_waypoints = 1'000'000;

/// Reads a path of the slider from a text file of comma-separated columns. The first line names
/// them with their units, in any order: "time [s], x [mm], y [mm], height [um], force [N]". One of
/// height and force is enough; where both columns stand, each line fills one of them. What is read
/// of spreadsheets and instruments tells `CsvTable`; a row that repeats the one before is one.
/// @return waypoints in the order of the file, SI units
/// Throws UserError with file, line and remedy.
std::vector<Waypoint> read_waypoint_file(const std::string& path);

} // namespace ionskin
