// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace ionskin::apps {

/// Message on a wrong command line that says what is wrong and what would be right: "error: ..."
/// and a line "  = ...".
/// @param app parser in the state in which parsing failed
/// @param error exception that the parser threw
/// @param words arguments of the command line, without the program's name
std::string explain_mistake(const CLI::App& app, const CLI::ParseError& error,
                            const std::vector<std::string>& words);

} // namespace ionskin::apps
