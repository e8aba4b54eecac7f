// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace ionskin {

/// Largest number of waypoints of one path, in a case or in a file.
inline constexpr std::size_t most_waypoints = 1'000'000;

/// Reads the waypoints of a slider's path from a CSV file, by the rules of `CsvTable`. The first
/// row names the columns with their units, in any order: "time [s], x [mm], y [mm], height [um],
/// force [N]", and optionally roll, pitch and yaw. One of height and force is enough; with both
/// columns, each row fills one of them. A row identical to the row before is skipped.
/// @return waypoints in the order of the file, in SI units; the path itself is not checked
/// Throws UserError with file, line and remedy.
std::vector<Waypoint> read_waypoint_file(const std::string& path);

} // namespace ionskin
