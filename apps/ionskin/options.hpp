// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "check.hpp"
#include "init.hpp"

namespace ionskin::apps {

/// How progress is shown: a bar on a terminal and plain lines elsewhere, JSON lines, or nothing.
enum class LogFormat { automatic, json, quiet };

struct RunOptions {
  std::string case_path;
  std::string output;
  std::vector<std::string> set_edits;
  int threads = 0; ///< 0: all processors
  bool overwrite = false;
  bool resume = false;
  std::string only; ///< "mechanics", "electrochemistry" or empty for both
  LogFormat log = LogFormat::automatic;
};

struct VerifyOptions {
  std::string part; ///< "mechanics", "electrochemistry", "chain" or empty for all
  int threads = 0;
};

struct ImpedanceOptions {
  std::string case_path;
  std::string output;
  std::vector<std::string> set_edits;
  std::string from, to; ///< frequencies with unit
  int points = 10;      ///< per decade
  bool overwrite = false;
};

using Command =
    std::variant<InitOptions, CheckOptions, RunOptions, VerifyOptions, ImpedanceOptions>;

} // namespace ionskin::apps
