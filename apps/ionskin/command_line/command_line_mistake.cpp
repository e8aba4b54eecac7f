// SPDX-License-Identifier: Apache-2.0
#include "command_line/command_line_mistake.hpp"

#include "ionskin/base/nearest_name.hpp"
#include "ionskin/base/text.hpp"
#include "ionskin/case/schema/suggest_key.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace ionskin::apps {
namespace {

std::string message(const std::string& problem, const std::string& remedy) {
  return fmt::format("error: {}\n  = {}", problem, remedy);
}

/// Finds the choice that a word means: the choice that it begins, or else the nearest one; empty
/// for none.
std::string nearest_choice(const std::string& word, const std::vector<std::string>& choices) {
  const auto longer = std::ranges::find_if(
      choices, [&word](const std::string& choice) { return choice.starts_with(word); });
  return longer != choices.end() ? *longer : base::nearest_name(word, choices);
}

std::string did_you_mean(const std::string& name) {
  return name.empty() ? "" : fmt::format("did you mean {}? ", name);
}

std::vector<std::string> verb_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* verb : app.get_subcommands({})) {
    names.push_back(verb->get_name());
  }
  return names;
}

std::vector<std::string> option_names(const CLI::App& verb) {
  std::vector<std::string> names;
  for (const CLI::Option* option : verb.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
  }
  return names;
}

bool has_option(const CLI::App& verb, const std::string& name) {
  const auto names = option_names(verb);
  return std::ranges::find(names, name) != names.end();
}

std::string call(const CLI::App& app, const CLI::App& verb) {
  return &app == &verb ? app.get_name() : app.get_name() + " " + verb.get_name();
}

/// Text of an option in a usage line: "CASE.toml" for a positional, "--output DIR" for an option.
std::string written(const CLI::Option& option) {
  const std::string type = option.get_type_name(), value = type.substr(0, type.find(':'));
  return option.get_lnames().empty() ? value
                                     : fmt::format("--{} {}", option.get_lnames().front(), value);
}

/// Usage line of a verb with all that it requires.
std::string usage(const CLI::App& app, const CLI::App& verb) {
  std::string text = call(app, verb);
  for (const CLI::Option* option : verb.get_options()) {
    if (option->get_required()) {
      text += " " + written(*option);
    }
  }
  return text;
}

/// Verb that does what a word means in other programs, such as "run" for "simulate"; empty for any
/// other word.
std::string verb_of_other_programs(const std::string& word) {
  static constexpr std::array<std::array<std::string_view, 2>, 11> known{{{"new", "init"},
                                                                          {"create", "init"},
                                                                          {"solve", "run"},
                                                                          {"simulate", "run"},
                                                                          {"validate", "check"},
                                                                          {"explain", "check"},
                                                                          {"plot", "report"},
                                                                          {"figures", "report"},
                                                                          {"gui", "studio"},
                                                                          {"diff", "compare"},
                                                                          {"train", "live"}}};
  const auto found =
      std::ranges::find(known, std::string_view(word), [](const auto& pair) { return pair[0]; });
  return found != known.end() ? std::string((*found)[1]) : "";
}

std::string unknown_verb(const CLI::App& app, const std::string& word) {
  const auto names = verb_names(app);
  const std::string other = verb_of_other_programs(word);
  const bool has_other = std::ranges::find(names, other) != names.end();
  const std::string nearest = has_other ? other : nearest_choice(word, names);
  if (nearest.empty() && word.ends_with(".toml")) {
    return message(fmt::format("\"{}\" is not a verb of {}", word, app.get_name()),
                   fmt::format("to run a case: {} run {} --output DIR", app.get_name(), word));
  }
  if (word == "help") {
    return message(fmt::format("\"help\" is not a verb of {}", app.get_name()),
                   fmt::format("write {0} --help, or {0} VERB --help", app.get_name()));
  }
  return message(fmt::format("\"{}\" is not a verb of {}", word, app.get_name()),
                 fmt::format("{}verbs: {}", did_you_mean(nearest), fmt::join(names, ", ")));
}

/// Word that follows an option on the command line; empty when it is an option itself.
std::string value_after(const std::vector<std::string>& words, const std::string& option) {
  const auto place = std::ranges::find(words, option);
  if (const std::size_t equals = option.find('='); equals != std::string::npos) {
    return option.substr(equals + 1);
  }
  const bool followed = place != words.end() && place + 1 != words.end();
  return followed && !(place + 1)->starts_with("--") ? *(place + 1) : "VALUE";
}

std::string unknown_option(const CLI::App& app, const CLI::App& verb, const std::string& option,
                           const std::vector<std::string>& words) {
  const std::string name = option.substr(0, option.find('='));
  const std::string problem = fmt::format("{} has no option {}", call(app, verb), name);
  if (has_option(verb, name)) {
    return message(fmt::format("{} comes before the verb", name),
                   fmt::format("write it after the verb: {} {}", call(app, verb), option));
  }
  const std::string nearest = base::nearest_name(name, option_names(verb));
  const std::string key =
      nearest.empty() ? suggest_key(name.substr(name.find_first_not_of('-'))) : "";
  if (!key.empty() && has_option(verb, "--set")) {
    const std::string edit = fmt::format("{}={}", key, value_after(words, option));
    const bool blanks = edit.find(' ') != std::string::npos;
    return message(problem, fmt::format("{} is a key of the case: write --set {}", key,
                                        blanks ? "\"" + edit + "\"" : edit));
  }
  for (const CLI::App* other : app.get_subcommands({})) {
    if (nearest.empty() && has_option(*other, name)) {
      return message(problem, fmt::format("it is an option of {}", call(app, *other)));
    }
  }
  return message(problem, fmt::format("{}options: {}", did_you_mean(nearest),
                                      fmt::join(option_names(verb), ", ")));
}

std::string missing(const CLI::App& app, const CLI::App& verb) {
  std::vector<std::string> needed;
  for (const CLI::Option* option : verb.get_options()) {
    if (option->get_required() && option->count() == 0) {
      needed.push_back(written(*option));
    }
  }
  return message(fmt::format("{} lacks {}", call(app, verb), fmt::join(needed, " and ")),
                 fmt::format("write {}; more: {} --help", usage(app, verb), call(app, verb)));
}

/// Message on the unknown choice in "--only: mech not in {mechanics,electrochemistry}".
std::optional<std::string> unknown_choice(const std::string& text) {
  const std::size_t colon = text.find(": "), open = text.find(" not in {");
  if (colon == std::string::npos || open == std::string::npos || open < colon ||
      !text.ends_with('}')) {
    return std::nullopt;
  }
  const std::string option = text.substr(0, colon);
  const std::string word = text.substr(colon + 2, open - colon - 2);
  const std::string list = text.substr(open + 9, text.size() - open - 10);
  const auto choices = base::split(list, ',');
  return message(fmt::format("{} {} is unknown", option, word),
                 fmt::format("{}choose one of {}", did_you_mean(nearest_choice(word, choices)),
                             fmt::join(choices, ", ")));
}

/// Message on the missing value in "--from: 1 required TEXT:{paper,quick} missing".
std::optional<std::string> missing_value(const std::string& text, const std::string& usage) {
  const std::size_t colon = text.find(": ");
  if (colon == std::string::npos || !text.ends_with(" missing")) {
    return std::nullopt;
  }
  const std::size_t open = text.find('{', colon), close = text.find('}', colon);
  const bool listed = open != std::string::npos && close != std::string::npos;
  return message(
      fmt::format("{} lacks its value", text.substr(0, colon)),
      listed
          ? fmt::format("choose one of {}",
                        fmt::join(base::split(text.substr(open + 1, close - open - 1), ','), ", "))
          : usage);
}

} // namespace

std::string explain_mistake(const CLI::App& app, const CLI::ParseError& error,
                            const std::vector<std::string>& words) {
  const auto is_option = [](const std::string& word) { return word.starts_with('-'); };
  const std::vector<CLI::App*> verbs = app.get_subcommands();
  const CLI::App& verb = verbs.empty() ? app : *verbs.front();
  const auto first_word = std::ranges::find_if_not(words, is_option);
  const std::vector<std::string> extras = app.remaining(true);
  // Options that nobody asked for explain more than what is missing.
  for (const std::string& word : words) {
    if (is_option(word) && std::ranges::find(extras, word) != extras.end()) {
      return unknown_option(app, verb, word, words);
    }
  }
  if (verbs.empty() && first_word != words.end()) {
    return unknown_verb(app, *first_word);
  }
  const std::string text = error.what(), name = error.get_name();
  if (name == "RequiredError" && !verbs.empty()) {
    return missing(app, verb);
  }
  if (!extras.empty()) {
    const auto extra = std::ranges::find_if(words, [&](const std::string& word) {
      return std::ranges::find(extras, word) != extras.end();
    });
    return message(
        fmt::format("\"{}\" is one word too many for {}",
                    extra == words.end() ? extras.front() : *extra, call(app, verb)),
        fmt::format("put a value that contains blanks in quotes; usage: {}", usage(app, verb)));
  }
  if (const auto choice = unknown_choice(text)) {
    return *choice;
  }
  const std::string help = fmt::format("{} --help lists its options", call(app, verb));
  if (const auto lacking = missing_value(text, help)) {
    return *lacking;
  }
  return message(text, help);
}

} // namespace ionskin::apps
