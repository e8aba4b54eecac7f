// SPDX-License-Identifier: Apache-2.0
#include "command_line/command_line_options.hpp"

#include <memory>

namespace ionskin::apps {

void add_help_verbs(CLI::App& app, Command& command) {
  app.add_subcommand("doctor", "List what this machine lacks for ionskin and how to get it")
      ->callback([&command] { command = DoctorOptions{}; });
  auto cache_options = std::make_shared<CacheOptions>();
  CLI::App* cache_verb = app.add_subcommand(
      "cache", "Show the files that older versions kept in the home folder, or remove them");
  cache_verb->add_option("action", cache_options->action, "clear: remove them")
      ->check(CLI::IsMember({"show", "clear"}));
  set_when_parsed(*cache_verb, cache_options, command);
  auto key_options = std::make_shared<KeysOptions>();
  CLI::App* key_verb = app.add_subcommand("keys", "List every key that a case can have");
  key_verb->add_option("word", key_options->word, "Only keys that contain it")->type_name("WORD");
  key_verb->add_flag("--json", key_options->json, "With type, unit, range and source, as JSON");
  set_when_parsed(*key_verb, key_options, command);
  auto completion_options = std::make_shared<CompletionOptions>();
  CLI::App* completion_verb = app.add_subcommand(
      "completion", "Print the shell's completion script: source <(ionskin completion bash)");
  completion_verb->add_option("shell", completion_options->shell, "Shell to complete in")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh"}));
  set_when_parsed(*completion_verb, completion_options, command);
  app.add_subcommand("man", "Print the manual page: ionskin man | man -l -")->callback([&command] {
    command = ManualOptions{};
  });
  auto cite_options = std::make_shared<CiteOptions>();
  CLI::App* cite_verb = app.add_subcommand("cite", "BibTeX of ionskin and of the methods it uses");
  cite_verb
      ->add_option("path", cite_options->path,
                   "Folder of a run, or a case file: only the methods that it uses")
      ->type_name("DIR");
  set_when_parsed(*cite_verb, cite_options, command);
}

} // namespace ionskin::apps
