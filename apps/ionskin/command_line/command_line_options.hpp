// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/options.hpp"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <vector>

namespace ionskin::apps {

// Options that several verbs share.
void add_case_option(CLI::App& verb, std::string& case_path);
void add_set_option(CLI::App& verb, std::vector<std::string>& edits);
/// Check of an option: what is wrong with the text, or nothing.
std::string whole_number_from_0(const std::string& text);
std::string whole_number_from_1(const std::string& text);
void add_threads_option(CLI::App& verb, int& threads);
void add_cache_option(CLI::App& verb);
void add_report_options(CLI::App& verb, bool& no_report, bool& figures);
void add_log_options(CLI::App& verb, LogFormat& log);
void add_output_option(CLI::App& verb, std::string& output);
CLI::Option* add_overwrite_option(CLI::App& verb, bool& overwrite);
/// --output, and how to treat a folder that has results: --overwrite or --resume.
void add_output_options(CLI::App& verb, std::string& output, bool& overwrite, bool& resume);

/// Parsing the verb makes its options the command.
template <class Options>
void set_when_parsed(CLI::App& verb, const std::shared_ptr<Options>& options, Command& command) {
  verb.callback([options, &command] { command = *options; });
}

/// sweep, fit, report, compare and studio.
void add_study_verbs(CLI::App& app, Command& command);
/// uncertainty, design and generate: many trials of a case. And motion, of a recording.
void add_trial_verbs(CLI::App& app, Command& command);
/// doctor, cache, keys, completion, man and cite.
void add_help_verbs(CLI::App& app, Command& command);

/// All verbs with their options; parsing fills `command`, which must outlive `app`.
void describe_command_line(CLI::App& app, Command& command);

} // namespace ionskin::apps
