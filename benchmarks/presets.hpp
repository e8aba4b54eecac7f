// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <cstdlib>
#include <string>
#include <vector>

/// The presets that a benchmark is to measure, from its command line. Ends the program after
/// `--help` (0) and where an argument is none (2).
inline std::vector<std::string> presets_of(const std::string& about, int argc, char** argv) {
  CLI::App program(about);
  std::vector<std::string> presets{"coarse", "standard"};
  program.add_option("preset", presets, "Presets to measure")
      ->check(CLI::IsMember({"coarse", "standard", "fine"}))
      ->capture_default_str();
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::exit(program.exit(error) == 0 ? 0 : 2);
  }
  return presets;
}
