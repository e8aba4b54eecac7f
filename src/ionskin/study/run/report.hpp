// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace ionskin::study {

/// Draws the figures and writes report.html of a finished run with ionskin's Python package.
/// @return what went wrong, with the remedy; empty on success. The results themselves do not depend
/// on it.
std::optional<std::string> make_report(const std::filesystem::path& folder);

/// The same for the figures of an impedance spectrum.
std::optional<std::string> draw_impedance(const std::filesystem::path& folder);

/// The same for the figure of a fit.
std::optional<std::string> draw_fit(const std::filesystem::path& folder);

} // namespace ionskin::study
