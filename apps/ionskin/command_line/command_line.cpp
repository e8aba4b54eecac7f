// SPDX-License-Identifier: Apache-2.0
#include "command_line/command_line.hpp"

#include "command_line/command_line_mistake.hpp"
#include "command_line/command_line_options.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/text.hpp"
#include "version.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

namespace ionskin::apps {
namespace {

constexpr const char* description =
    "ionskin simulates ionic artificial skins: frictional contact of a slider with a layered "
    "skin,\n"
    "and the electrode currents of the ion transport that its shear drives.\n\n"
    "First steps:\n"
    "  ionskin init my_skin.toml              write a commented starter case\n"
    "  ionskin check my_skin.toml --explain   see what it means before running\n"
    "  ionskin run my_skin.toml -o out        run both studies; open out/report.html";

constexpr const char* exit_codes =
    "Exit codes: 0 success, 2 the case or command line is wrong, 3 a solver gave up (what was\n"
    "finished is kept; in a sweep: every point failed), 4 points of a sweep in parts are still to\n"
    "be solved, or the report could not be made, 5 the scheduler of a cluster is lost (finish\n"
    "with --resume), 130 interrupted (finish with --resume where the command has this option).";

void add_init(CLI::App& app, Command& command) {
  auto options = std::make_shared<InitOptions>();
  CLI::App* verb = app.add_subcommand("init", "Write a commented starter case");
  verb->add_option("path", options->path, "File to write")->required()->type_name("CASE.toml");
  verb->add_option(
          "--from", options->from,
          "Case to start from: finger (a fingertip strokes the skin with 1 N), quick (a block, "
          "seconds), paper (the article's block, 65 N, full accuracy), taxels (four parts of the "
          "top electrode), reciprocating "
          "(back and forth), waypoints (a fingertip draws an arc with 1 to 2 N), rolling "
          "(a ball rolls with 5 N), pinch (two fingertips), poroelastic (moving water), "
          "bending (a wet strip, no slider), strain_file (a shear history of your own)")
      ->check(CLI::IsMember({"paper", "quick", "finger", "taxels", "reciprocating", "waypoints",
                             "rolling", "pinch", "poroelastic", "bending", "strain_file"}))
      ->capture_default_str();
  set_when_parsed(*verb, options, command);
}

void add_check(CLI::App& app, Command& command) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* verb = app.add_subcommand("check", "Check a case without running it");
  add_case_option(*verb, options->case_path);
  add_set_option(*verb, options->set_edits);
  verb->add_flag("--explain", options->explain,
                 "Show SI values, derived scales, unknowns, memory and expected time");
  verb->add_flag("--json", options->json, "The same for programs: values, scales and cost as JSON");
  set_when_parsed(*verb, options, command);
}

void add_run(CLI::App& app, Command& command) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* verb =
      app.add_subcommand("run", "Run a case: contact mechanics, ion transport, results");
  add_case_option(*verb, options->case_path);
  add_output_options(*verb, options->output, options->overwrite, options->resume);
  add_set_option(*verb, options->set_edits);
  add_threads_option(*verb, options->threads);
  verb->add_option("--only", options->only,
                   "Run one study: electrochemistry takes up finished mechanics")
      ->check(CLI::IsMember({"mechanics", "electrochemistry"}));
  add_report_options(*verb, options->no_report, options->figures);
  add_cache_option(*verb);
  add_log_options(*verb, options->log);
  set_when_parsed(*verb, options, command);
}

void add_verify(CLI::App& app, Command& command) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* verb = app.add_subcommand("verify", "Run the verification set and print its table");
  verb->add_option("part", options->part, "Only this part")
      ->check(CLI::IsMember({"mechanics", "electrochemistry", "poroelasticity", "chain"}));
  verb->add_option("--csv", options->csv, "Write the table to this file too")->type_name("FILE");
  add_threads_option(*verb, options->threads);
  set_when_parsed(*verb, options, command);
}

void add_impedance(CLI::App& app, Command& command) {
  auto options = std::make_shared<ImpedanceOptions>();
  CLI::App* verb = app.add_subcommand(
      "impedance", "Small-signal spectrum of the cell at rest: CSV, Nyquist and Bode figures");
  add_case_option(*verb, options->case_path);
  verb->add_option("--from", options->from, "Lowest frequency, such as 0.01Hz")
      ->required()
      ->type_name("FREQUENCY");
  verb->add_option("--to", options->to, "Highest frequency, such as 1kHz")
      ->required()
      ->type_name("FREQUENCY");
  verb->add_option("--points", options->points, "Frequencies per decade")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  add_output_option(*verb, options->output);
  add_set_option(*verb, options->set_edits);
  add_overwrite_option(*verb, options->overwrite);
  set_when_parsed(*verb, options, command);
}

void add_live(CLI::App& app, Command& command) {
  auto options = std::make_shared<LiveOptions>();
  CLI::App* verb = app.add_subcommand(
      "live", "Train the reduced skin of a case, to be stepped in a loop (docs/live.md)");
  verb->add_option("case", options->case_path,
                   "Case file; or, with --fmu, the file of a reduced skin that is there")
      ->required()
      ->type_name("CASE.toml");
  verb->add_option("-o,--output", options->output, "File of the reduced skin, such as skin.live")
      ->type_name("FILE");
  verb->add_option("--fmu", options->fmu,
                   "Write it as an FMU for co-simulation (FMI 2.0) too, such as skin.fmu")
      ->type_name("FILE");
  CLI::Option* trajectories =
      verb->add_option("--trajectories", options->trajectories, "Random touches to train on")
          ->check(CLI::Range(2, 1000))
          ->capture_default_str();
  CLI::Option* validation =
      verb->add_option(
              "--validation", options->validation,
              "Other random touches that measure the errors; 90 give 99 % confidence that 95 % "
              "of all touches keep them")
          ->check(CLI::Range(1, 1000))
          ->capture_default_str();
  CLI::Option* friction =
      verb->add_option("--friction", options->friction,
                       "Lowest and highest coefficient of friction, any of which can be set later; "
                       "the case's alone without it")
          ->type_name("LOW HIGH");
  CLI::Option* tilt =
      verb->add_option("--tilt", options->tilt,
                       "Steepest tilt of the slider to train, roll and pitch together, up to 5 "
                       "degrees; upright alone without it")
          ->type_name("DEG");
  CLI::Option* spin =
      verb->add_option("--spin", options->spin,
                       "Fastest turn about z to train, of a slider without sharp edges, in "
                       "degrees a second; none without it")
          ->type_name("DEG/S");
  CLI::Option* slider =
      verb->add_option("--slider", options->slider,
                       "Which slider of a list [[slider]] to train, counted from 1 as the ends of "
                       "signals are")
          ->type_name("NUMBER");
  CLI::Option* seed = verb->add_option("--seed", options->seed, "Seed of the touches")
                          ->check(CLI::Range(0, 2147483647))
                          ->capture_default_str();
  CLI::Option* replace =
      verb->add_flag("--overwrite", options->overwrite, "Replace existing files");
  verb->add_flag("--resume", options->resume, "Finish an interrupted training")->excludes(replace);
  add_set_option(*verb, options->set_edits);
  add_threads_option(*verb, options->threads);
  add_cache_option(*verb);
  add_log_options(*verb, options->log);
  verb->callback([=, &command] {
    options->trains = !options->output.empty() || !options->set_edits.empty() || options->resume ||
                      trajectories->count() + validation->count() + seed->count() +
                              friction->count() + tilt->count() + spin->count() + slider->count() >
                          0;
    command = *options;
  });
}

} // namespace

void describe_command_line(CLI::App& app, Command& command) {
  app.description(description);
  app.name("ionskin");
  app.footer(exit_codes);
  app.set_version_flag("--version", version_text());
  app.require_subcommand(1);
  add_init(app, command);
  add_check(app, command);
  add_run(app, command);
  add_impedance(app, command);
  add_live(app, command);
  add_study_verbs(app, command);
  add_trial_verbs(app, command);
  add_verify(app, command);
  add_help_verbs(app, command);
}

std::optional<Command> parse_command_line(int argc, char** argv, int& exit_code) {
  CLI::App app;
  Command command;
  describe_command_line(app, command);
  if (argc == 1) {
    std::fputs(app.help().c_str(), stdout);
    exit_code = 0;
    return std::nullopt;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) { // --help and --version
      exit_code = app.exit(error);
      return std::nullopt;
    }
    const std::string mistake = explain_mistake(app, error, {argv + 1, argv + argc});
    std::fprintf(stderr, "%s\n", base::printable(mistake).c_str());
    exit_code = static_cast<int>(ExitCode::user_error);
    return std::nullopt;
  }
  return command;
}

} // namespace ionskin::apps
