// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace ionskin::apps {

/// Explanation of what is wrong with a command line, and of what would be right: "error: ..." and a
/// line " = ...".
/// @param app as it stood when parsing failed
/// @param words of the command line, without the program's name
std::string explain_mistake(const CLI::App& app, const CLI::ParseError& error,
                            const std::vector<std::string>& words);

} // namespace ionskin::apps
