// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ionskin::apps {

/// One option or positional of a verb, as the parser itself knows it.
struct OptionReference {
  std::vector<std::string> names;   ///< "-o", "--output"; one bare word for a positional
  std::string value;                ///< value that it takes, such as "DIR"; empty for a flag
  std::vector<std::string> choices; ///< when it takes one of a few words
  std::string help;
  bool positional = false;
};

struct VerbReference {
  std::string name, help;
  std::vector<OptionReference> options;
};

/// The whole command line: what completion and the manual page are made of.
struct CommandReference {
  std::string description, exit_codes;
  std::vector<OptionReference> options; ///< before any verb
  std::vector<VerbReference> verbs;
};

CommandReference command_reference();

} // namespace ionskin::apps
