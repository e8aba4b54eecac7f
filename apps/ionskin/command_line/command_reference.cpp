// SPDX-License-Identifier: Apache-2.0
#include "command_line/command_reference.hpp"

#include "command_line/command_line_options.hpp"
#include "ionskin/base/text.hpp"

#include <CLI/CLI.hpp>

namespace ionskin::apps {
namespace {

/// Choices of an option: the words between braces that CLI11 appends to its type,
/// "TEXT:{paper,quick}".
std::vector<std::string> choices_of(const std::string& type) {
  const std::size_t open = type.find(":{");
  if (open == std::string::npos) {
    return {};
  }
  return base::split(type.substr(open + 2, type.rfind('}') - open - 2), ',');
}

OptionReference reference_of(const CLI::Option& option) {
  OptionReference result;
  for (const std::string& name : option.get_snames()) {
    result.names.push_back("-" + name);
  }
  for (const std::string& name : option.get_lnames()) {
    result.names.push_back("--" + name);
  }
  result.positional = result.names.empty();
  if (result.positional) {
    result.names.push_back(option.get_name(true));
  }
  if (option.get_expected_max() > 0 && option.get_items_expected_max() > 0) {
    const std::string type = option.get_type_name();
    result.choices = choices_of(type);
    result.value = type.substr(0, type.find(':'));
  }
  result.help = option.get_description();
  return result;
}

std::vector<OptionReference> options_of(const CLI::App& app) {
  std::vector<OptionReference> result;
  for (const CLI::Option* option : app.get_options()) {
    result.push_back(reference_of(*option));
  }
  return result;
}

} // namespace

CommandReference command_reference() {
  CLI::App app;
  Command unused;
  describe_command_line(app, unused);
  CommandReference result{app.get_description(), app.get_footer(), options_of(app), {}};
  for (const CLI::App* verb : app.get_subcommands({})) {
    result.verbs.push_back({verb->get_name(), verb->get_description(), options_of(*verb)});
  }
  return result;
}

} // namespace ionskin::apps
