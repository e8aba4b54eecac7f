// SPDX-License-Identifier: Apache-2.0
#include "command_line/manual_page.hpp"

#include "command_line/command_reference.hpp"
#include "version.hpp"

#include <fmt/format.h>

#include <string>

namespace ionskin::apps {
namespace {

/// Escapes a text for roff: hyphens that can be copied, backslashes, and lines that would start a
/// request.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    const bool at_start = result.empty() || result.back() == '\n';
    if (letter == '\\') {
      result += "\\e";
    } else if (letter == '-') {
      result += "\\-";
    } else if (at_start && (letter == '.' || letter == '\'')) {
      result += std::string("\\&") + letter;
    } else {
      result += letter;
    }
  }
  return result;
}

std::string value_of(const OptionReference& option) {
  return option.choices.empty() ? option.value : fmt::format("{}", fmt::join(option.choices, "|"));
}

void print_option(const OptionReference& option) {
  const std::string value = option.positional || option.value.empty()
                                ? ""
                                : fmt::format(" \\fI{}\\fR", escaped(value_of(option)));
  fmt::print(".TP\n\\fB{}\\fR{}\n{}\n", escaped(fmt::format("{}", fmt::join(option.names, ", "))),
             value, escaped(option.help));
  if (option.positional && !value_of(option).empty()) {
    fmt::print("({})\n", escaped(value_of(option)));
  }
}

void print_verb(const VerbReference& verb) {
  fmt::print(".SS \"ionskin {}\"\n{}.\n", escaped(verb.name), escaped(verb.help));
  for (const OptionReference& option : verb.options) {
    print_option(option);
  }
}

} // namespace

int manual_page() {
  const CommandReference reference = command_reference();
  fmt::print(".TH IONSKIN 1 \"\" \"{}\" \"User Commands\"\n", escaped(version_text()));
  fmt::print(".SH NAME\nionskin \\- simulate ionic artificial skins\n");
  fmt::print(".SH SYNOPSIS\n.B ionskin\n.I VERB\n[\\fIOPTIONS\\fR]\n");
  fmt::print(".SH DESCRIPTION\n.nf\n{}\n.fi\n", escaped(reference.description));
  fmt::print(".SH OPTIONS\n");
  for (const OptionReference& option : reference.options) {
    print_option(option);
  }
  fmt::print(".SH VERBS\n");
  for (const VerbReference& verb : reference.verbs) {
    print_verb(verb);
  }
  fmt::print(".SH ENVIRONMENT\n"
             ".TP\n.B IONSKIN_CACHE\nFolder of the cache of older versions, for ionskin cache; "
             "otherwise $XDG_CACHE_HOME/ionskin or ~/.cache/ionskin.\n"
             ".TP\n.B IONSKIN_DATA\nFolder that holds cases and materials.\n");
  fmt::print(".SH EXIT STATUS\n{}\n", escaped(reference.exit_codes));
  return 0;
}

} // namespace ionskin::apps
