// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ionskin::apps {

/// Option or positional argument of a verb, as the parser describes it.
struct OptionReference {
  std::vector<std::string> names; ///< "-o", "--output"; one bare word for a positional
  std::string value; ///< name of the value that the option takes, such as "DIR"; empty for a flag
  /// Words of which the value must be one; empty where any value is allowed.
  std::vector<std::string> choices;
  std::string help;        ///< sentence of the help text
  bool positional = false; ///< true for a positional argument
};

/// Verb of `ionskin` with its help sentence and its options.
struct VerbReference {
  std::string name, help;
  std::vector<OptionReference> options;
};

/// Description of the whole command line, from which shell completion and the manual page are made.
struct CommandReference {
  std::string description, exit_codes;
  /// Options of the program itself, which stand before a verb.
  std::vector<OptionReference> options;
  std::vector<VerbReference> verbs;
};

/// Reads the description of the command line from the parser of `describe_command_line`.
CommandReference command_reference();

} // namespace ionskin::apps
