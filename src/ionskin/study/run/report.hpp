// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/run/python_module.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace ionskin::study {

/// Writes report.html into the folder of a finished run or sweep, with ionskin's Python package.
/// @param figures true: writes the figures as separate files, too
/// @param progress receives the finished fraction; may be empty
/// @return reason for a failure with its remedy; empty on success. The results do not depend on the
/// report.
std::optional<std::string> make_report(const std::filesystem::path& folder, bool figures,
                                       const PythonProgress& progress);

/// Draws the figures of an impedance spectrum from the files in a folder.
/// @return reason for a failure with its remedy; empty on success
std::optional<std::string> draw_impedance(const std::filesystem::path& folder);

/// Draws the figure of a fit from the files in a folder.
/// @return reason for a failure with its remedy; empty on success
std::optional<std::string> draw_fit(const std::filesystem::path& folder);

} // namespace ionskin::study
