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
/// Validator of an option whose value is a whole number from 0. Returns a message, or an empty text
/// for a valid value.
std::string whole_number_from_0(const std::string& text);
/// Validator of an option whose value is a whole number from 1. Returns a message, or an empty text
/// for a valid value.
std::string whole_number_from_1(const std::string& text);
void add_threads_option(CLI::App& verb, int& threads);
void add_cache_option(CLI::App& verb);
void add_report_options(CLI::App& verb, bool& no_report, bool& figures);
void add_log_options(CLI::App& verb, LogFormat& log);
void add_output_option(CLI::App& verb, std::string& output);
CLI::Option* add_overwrite_option(CLI::App& verb, bool& overwrite);
/// Adds --output and the options for a folder that already has results: --overwrite and --resume.
void add_output_options(CLI::App& verb, std::string& output, bool& overwrite, bool& resume);

/// Makes the parser copy `options` to `command` once the verb was parsed. `command` must outlive
/// the parser.
template <class Options>
void set_when_parsed(CLI::App& verb, const std::shared_ptr<Options>& options, Command& command) {
  verb.callback([options, &command] { command = *options; });
}

/// Adds the verbs sweep, fit, report, compare, studio and cluster.
void add_study_verbs(CLI::App& app, Command& command);
/// Adds the verbs uncertainty, design and generate, which run many trials of a case, and motion,
/// which converts a recording.
void add_trial_verbs(CLI::App& app, Command& command);
/// Adds the verbs doctor, cache, keys, completion, man and cite.
void add_help_verbs(CLI::App& app, Command& command);

/// Adds all verbs of `ionskin` with their options to a parser. Parsing sets `command`, which must
/// outlive `app`.
void describe_command_line(CLI::App& app, Command& command);

} // namespace ionskin::apps
