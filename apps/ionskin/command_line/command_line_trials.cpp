// SPDX-License-Identifier: Apache-2.0
#include "command_line/command_line_options.hpp"

#include <memory>

namespace ionskin::apps {
namespace {

void add_trial_options(CLI::App& verb, TrialOptions& options) {
  add_case_option(verb, options.case_path);
  add_output_options(verb, options.output, options.overwrite, options.resume);
  add_set_option(verb, options.set_edits);
  add_threads_option(verb, options.threads);
  add_cache_option(verb);
  verb.add_option("--on", options.on,
                  "Do the runs on the workers of a cluster, see ionskin cluster")
      ->type_name("SCHEDULER.json");
  verb.add_flag("-q,--quiet", options.quiet, "Print errors only");
}

void add_vary_option(CLI::App& verb, std::vector<std::string>& vary, bool required) {
  verb.add_option("--vary", vary,
                  "Key and its distribution: \"contact.friction=uniform(0.1, 0.4)\"; loguniform, "
                  "triangular, normal, lognormal too, with units and deviations in %")
      ->required(required)
      ->type_name("KEY=DISTRIBUTION")
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all();
}

void add_uncertainty(CLI::App& app, Command& command) {
  auto options = std::make_shared<UncertaintyOptions>();
  CLI::App* verb = app.add_subcommand(
      "uncertainty", "Results of uncertain keys: quantiles, bands over time, Sobol' indices");
  add_trial_options(*verb, *options);
  add_vary_option(*verb, options->vary, true);
  verb->add_option("--samples", options->samples, "Number of runs")
      ->check(CLI::Range(16, 100000))
      ->capture_default_str();
  verb->add_option("--design", options->design,
                   "How they fill the distributions; sobol can be given more samples later")
      ->check(CLI::IsMember({"sobol", "lhs"}))
      ->capture_default_str();
  verb->add_option("--seed", options->seed, "Seed of the design")
      ->check(CLI::Range(0, 2147483647))
      ->capture_default_str();
  verb->add_option("--metrics", options->metrics, "Metrics to analyse, as in summary.json")
      ->type_name("NAME,NAME")
      ->delimiter(',')
      ->expected(1)
      ->take_all();
  verb->add_option("--least-q2", options->least_q2,
                   "No indices where the surrogate explains less of the variance at points that "
                   "it has not seen")
      ->check(CLI::Range(0.01, 0.9999))
      ->capture_default_str();
  set_when_parsed(*verb, options, command);
}

CLI::Option* add_list(CLI::App& verb, const std::string& name, std::vector<std::string>& values,
                      const std::string& help, const std::string& type) {
  return verb.add_option(name, values, help)
      ->type_name(type)
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all();
}

void add_design(CLI::App& app, Command& command) {
  auto options = std::make_shared<DesignOptions>();
  CLI::App* verb = app.add_subcommand(
      "design", "Best values of free keys under constraints, with few runs, each kept");
  add_trial_options(*verb, *options);
  add_list(*verb, "--free", options->free,
           "Key and its range: \"skin.layers[1].thickness=50:500 um\"", "KEY=LOWEST:HIGHEST")
      ->required();
  CLI::Option* maximise =
      verb->add_option("--maximise", options->maximise, "Metric to make as large as can be")
          ->type_name("METRIC");
  verb->add_option("--minimise", options->minimise, "Metric to make as small as can be")
      ->type_name("METRIC")
      ->excludes(maximise);
  add_list(*verb, "--subject-to", options->subject_to,
           "Constraint: \"normal_force_slide < 3 N\"; <=, >, >= and == too", "CONSTRAINT");
  verb->add_option("--budget", options->budget, "Runs at most")
      ->check(CLI::Range(8, 100000))
      ->capture_default_str();
  verb->add_option("--seed", options->seed, "Seed of the search")
      ->check(CLI::Range(0, 2147483647))
      ->capture_default_str();
  set_when_parsed(*verb, options, command);
}

void add_generate(CLI::App& app, Command& command) {
  auto options = std::make_shared<GenerateOptions>();
  CLI::App* verb = app.add_subcommand(
      "generate",
      "Training data: many random touches of a case or of a live skin, their signals at 1 kHz and "
      "labels, in one HDF5 file");
  add_trial_options(*verb, *options);
  verb->get_option("case")
      ->description("Case file, or the file of a live skin")
      ->type_name("CASE.toml|SKIN.live");
  verb->add_option("--touches", options->touches, "Number of touches")
      ->required()
      ->check(CLI::Range(1, 1000000));
  add_vary_option(*verb, options->vary, false);
  verb->add_option("--balance", options->balance,
                   "Choose at random so many rows each in which all sticks, part slips and all "
                   "slips while the slider moves, as indices in the file")
      ->check(CLI::Range(1, 100000000))
      ->type_name("ROWS");
  verb->add_option("--seed", options->seed, "Seed of the touches")
      ->check(CLI::Range(0, 2147483647))
      ->capture_default_str();
  set_when_parsed(*verb, options, command);
}

void add_motion(CLI::App& app, Command& command) {
  auto options = std::make_shared<MotionOptions>();
  CLI::App* verb = app.add_subcommand(
      "motion", "Make a path of waypoints from recordings of a robot, and say what was done");
  verb->add_option("recording", options->recordings,
                   "CSV file; of several the first gives the instants")
      ->required()
      ->type_name("FILE.csv");
  verb->add_option("-o,--output", options->output, "File of the path, such as path.csv")
      ->required()
      ->type_name("PATH.csv");
  add_list(*verb, "--column", options->columns,
           "Meaning of a column whose name does not say it: \"z=tip height [mm]\"; roles: time, "
           "x, y, z, qx, qy, qz, qw, fx, fy, fz, height, force",
           "ROLE=NAME");
  const auto text = [&](const char* name, std::string& value, const char* help, const char* type) {
    verb->add_option(name, value, help)->type_name(type);
  };
  text("--origin", options->origin,
       "Corner (0, 0) of the skin's top face in the recording's frame: \"0.4 m, -0.1 m, 32 mm\"",
       "X,Y,Z");
  text("--x-axis", options->x_axis, "Direction of the skin's x there: 0,1,0", "X,Y,Z");
  text("--y-axis", options->y_axis, "Direction of the skin's y there", "X,Y,Z");
  text("--tool", options->tool,
       "Tip of the finger from the tracked point, in the frame that the quaternion turns", "X,Y,Z");
  verb->add_option("--force-in", options->force_in, "Frame of the force's components")
      ->check(CLI::IsMember({"skin", "recording", "tool"}))
      ->capture_default_str();
  verb->add_option("--level", options->level,
                   "What leads in contact: auto takes the force where there is one")
      ->check(CLI::IsMember({"auto", "height", "force"}))
      ->capture_default_str();
  text("--contact-force", options->contact_force,
       "Force above which the finger touches (default: above the noise)", "FORCE");
  verb->add_flag("--tare", options->tare, "Subtract the force at rest");
  verb->add_flag("--angles", options->angles,
                 "Take roll, pitch and yaw of the quaternion into the path (a tilt of at most 5 "
                 "degrees); without it the finger stays upright");
  text("--gap", options->gap, "Height off the skin where none is recorded (default: 1 mm)",
       "LENGTH");
  text("--rate", options->rate, "Resample to so many rows a second, such as 100Hz", "FREQUENCY");
  text("--filter", options->filter, "Low-pass without delay, 3 dB at such as 20Hz", "FREQUENCY");
  add_overwrite_option(*verb, options->overwrite);
  verb->add_flag("-q,--quiet", options->quiet, "Print errors only");
  set_when_parsed(*verb, options, command);
}

} // namespace

void add_trial_verbs(CLI::App& app, Command& command) {
  add_uncertainty(app, command);
  add_design(app, command);
  add_generate(app, command);
  add_motion(app, command);
}

} // namespace ionskin::apps
