// SPDX-License-Identifier: Apache-2.0
#include "command_line/completion.hpp"

#include "command_line/command_reference.hpp"

#include "ionskin/case/schema/schema.hpp"

#include <fmt/format.h>

#include <vector>

namespace ionskin::apps {
namespace {

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

/// Names of the keys that `--set` and `--over` take as they are, without keys that hold an index or
/// a name of the user's.
std::string plain_keys() {
  std::vector<std::string> keys;
  for (const SchemaRow& row : schema()) {
    if (row.key.find("[]") == std::string::npos && row.key.find("NAME") == std::string::npos) {
      keys.push_back(row.key + "=");
    }
  }
  return joined(keys);
}

std::string candidates(const OptionReference& option) {
  if (!option.choices.empty()) {
    return fmt::format("COMPREPLY=($(compgen -W \"{}\" -- \"$word\"))", joined(option.choices));
  }
  if (option.value.starts_with("KEY=")) {
    return "compopt -o nospace; COMPREPLY=($(compgen -W \"$keys\" -- \"$word\"))";
  }
  if (option.value == "DIR") {
    return "compopt -o filenames; COMPREPLY=($(compgen -d -- \"$word\"))";
  }
  return "compopt -o filenames; COMPREPLY=($(compgen -f -- \"$word\"))";
}

/// Branch of the script's inner `case` for an option that takes a value: the words that may follow.
std::string branch(const OptionReference& option) {
  return fmt::format("        {}) {}; return ;;\n", fmt::join(option.names, "|"),
                     candidates(option));
}

std::string verb_case(const VerbReference& verb) {
  std::vector<std::string> names;
  std::string branches;
  std::string words = "compopt -o filenames; COMPREPLY=($(compgen -f -- \"$word\"))";
  for (const OptionReference& option : verb.options) {
    if (option.positional) {
      words = candidates(option);
      continue;
    }
    names.insert(names.end(), option.names.begin(), option.names.end());
    if (!option.value.empty()) {
      branches += branch(option);
    }
  }
  return fmt::format("    {})\n"
                     "      case \"$before\" in\n{}      esac\n"
                     "      if [[ \"$word\" == -* ]]; then\n"
                     "        COMPREPLY=($(compgen -W \"{}\" -- \"$word\"))\n"
                     "      else\n        {}\n      fi ;;\n",
                     verb.name, branches, joined(names), words);
}

} // namespace

int completion(const CompletionOptions& options) {
  const CommandReference reference = command_reference();
  std::vector<std::string> first;
  std::string cases;
  for (const VerbReference& verb : reference.verbs) {
    first.push_back(verb.name);
    cases += verb_case(verb);
  }
  for (const OptionReference& option : reference.options) {
    first.insert(first.end(), option.names.begin(), option.names.end());
  }
  if (options.shell == "zsh") {
    fmt::print("autoload -U +X compinit && compinit\nautoload -U +X bashcompinit && bashcompinit\n"
               "(( $+functions[compopt] )) || compopt() {{ :; }}\n");
  }
  // The shell takes '=' for a word of its own; the key before it is all that is completed.
  fmt::print(
      "_ionskin() {{\n"
      "  local word=\"${{COMP_WORDS[COMP_CWORD]}}\" before=\"${{COMP_WORDS[COMP_CWORD-1]}}\"\n"
      "  local keys=\"{}\"\n"
      "  COMPREPLY=()\n"
      "  if ((COMP_CWORD == 1)); then\n"
      "    COMPREPLY=($(compgen -W \"{}\" -- \"$word\"))\n"
      "    return\n"
      "  fi\n"
      "  case \"${{COMP_WORDS[1]}}\" in\n{}  esac\n"
      "}}\n"
      "complete -F _ionskin ionskin\n",
      plain_keys(), joined(first), cases);
  return 0;
}

} // namespace ionskin::apps
