// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/run/python_module.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace ionskin::study {

/// Writes report.html of a finished run or sweep with ionskin's Python package.
/// @param figures write them as files too
/// @param progress of the drawing
/// @return what went wrong, with the remedy; empty on success. The results themselves do not depend
/// on it.
std::optional<std::string> make_report(const std::filesystem::path& folder, bool figures,
                                       const PythonProgress& progress);

/// Draws the figures of an impedance spectrum. @return as of `make_report`
std::optional<std::string> draw_impedance(const std::filesystem::path& folder);

/// Draws the figure of a fit. @return as of `make_report`
std::optional<std::string> draw_fit(const std::filesystem::path& folder);

} // namespace ionskin::study
