// SPDX-License-Identifier: Apache-2.0
#include "command_line/command_line_options.hpp"

#include <charconv>
#include <map>

namespace ionskin::apps {

void add_case_option(CLI::App& verb, std::string& case_path) {
  verb.add_option("case", case_path, "Case file")->required()->type_name("CASE.toml");
}

void add_set_option(CLI::App& verb, std::vector<std::string>& edits) {
  verb.add_option(
          "--set", edits,
          "Change a key for this run: --set contact.friction=0.2, --set \"motion.stroke=3 mm\"")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all();
}

namespace {

std::string whole_number_from(int least, const std::string& text) {
  int value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool good = status == std::errc() && end == text.data() + text.size() && value >= least;
  return good ? "" : text + " is not a whole number of at least " + std::to_string(least);
}

} // namespace

std::string whole_number_from_0(const std::string& text) {
  return whole_number_from(0, text);
}

std::string whole_number_from_1(const std::string& text) {
  return whole_number_from(1, text);
}

void add_threads_option(CLI::App& verb, int& threads) {
  verb.add_option("--threads", threads,
                  "Threads to use at most (default: all processors that it may run on)")
      ->check(whole_number_from_1);
}

void add_cache_option(CLI::App& verb) {
  verb.add_flag_callback(
      "--no-cache", [] {},
      "Has no effect any more: nothing is kept in the home folder (see ionskin cache)");
}

void add_report_options(CLI::App& verb, bool& no_report, bool& figures) {
  CLI::Option* none = verb.add_flag("--no-report", no_report,
                                    "Leave out the report (ionskin report DIR makes it later)");
  verb.add_flag("--figures", figures,
                "Write its figures as PNG, SVG and PDF files too, in DIR/figures (ionskin report\n"
                "DIR --figures does so later)")
      ->excludes(none);
}

void add_log_options(CLI::App& verb, LogFormat& log) {
  static const std::map<std::string, LogFormat> formats{{"auto", LogFormat::automatic},
                                                        {"bar", LogFormat::bar},
                                                        {"lines", LogFormat::lines},
                                                        {"json", LogFormat::json},
                                                        {"none", LogFormat::none}};
  verb.add_option_function<std::string>(
          "--progress", [&log](const std::string& format) { log = formats.at(format); },
          "Progress on stderr: a bar on a terminal and lines in a log (auto), one of them, JSON\n"
          "lines, or none")
      ->check(CLI::IsMember({"auto", "bar", "lines", "json", "none"}));
  verb.add_option_function<std::string>(
          "--log",
          [&log](const std::string& format) {
            log = format == "json" ? LogFormat::json : LogFormat::automatic;
          },
          "The same as --progress auto or json")
      ->check(CLI::IsMember({"text", "json"}));
  verb.add_flag_callback(
      "-q,--quiet", [&log] { log = LogFormat::quiet; },
      "Neither progress nor a summary of the results");
}

void add_output_option(CLI::App& verb, std::string& output) {
  verb.add_option("-o,--output", output, "Folder for the results")->required()->type_name("DIR");
}

CLI::Option* add_overwrite_option(CLI::App& verb, bool& overwrite) {
  return verb.add_flag("--overwrite", overwrite, "Replace the results in an existing folder");
}

void add_output_options(CLI::App& verb, std::string& output, bool& overwrite, bool& resume) {
  add_output_option(verb, output);
  CLI::Option* replace = add_overwrite_option(verb, overwrite);
  verb.add_flag("--resume", resume, "Finish an interrupted run in its folder")->excludes(replace);
}

} // namespace ionskin::apps
