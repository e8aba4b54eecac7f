// SPDX-License-Identifier: Apache-2.0
#include "command_line/command_line_options.hpp"
#include "ionskin/base/byte_count.hpp"

#include <memory>

namespace ionskin::apps {
namespace {

void add_design_options(CLI::App& verb, SweepOptions& options) {
  verb.add_option("--over", options.over,
                  "Key to vary and its values: contact.friction=0.05:0.05:0.5 (first:step:last), "
                  "\"motion.preload=1 um,2 um\"; several make a grid; with --samples an interval: "
                  "contact.friction=0.05:0.5")
      ->type_name("KEY=VALUES")
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all();
  CLI::Option* samples =
      verb.add_option("--samples", options.samples, "Number of points within the intervals")
          ->check(CLI::Range(1, 100000));
  verb.add_option("--sampling", options.sampling, "How they fill the intervals")
      ->check(CLI::IsMember({"sobol", "latin"}))
      ->needs(samples)
      ->capture_default_str();
  verb.add_option("--seed", options.seed, "Seed of the design")
      ->check(CLI::Range(0, 2147483647))
      ->needs(samples)
      ->capture_default_str();
}

/// Adds the options that divide a sweep among machines that share its folder, and returns the two
/// that work from its plan.json only.
std::vector<CLI::Option*> add_part_options(CLI::App& verb, SweepOptions& options) {
  CLI::Option* plan = verb.add_flag(
      "--plan", options.plan,
      "Only write DIR/plan.json: the points in batches, with memory and time of each");
  CLI::Option* batch =
      verb.add_option("--do-batch", options.batch, "Do batch K, from 0, of the plan in DIR")
          ->type_name("K")
          ->check(whole_number_from_0);
  CLI::Option* collect =
      verb.add_flag("--collect", options.collect,
                    "Write the tables and the report from the points that are in DIR");
  CLI::Option* on =
      verb.add_option("--on", options.on,
                      "Do the batches on the workers of a cluster, see ionskin cluster")
          ->type_name("SCHEDULER.json");
  on->excludes(plan)->excludes(batch)->excludes(collect);
  batch->excludes(plan)->excludes(collect);
  collect->excludes(plan);
  return {batch, collect};
}

void add_sweep(CLI::App& app, Command& command) {
  auto options = std::make_shared<SweepOptions>();
  CLI::App* verb = app.add_subcommand("sweep", "Run a case at many values of its keys");
  CLI::Option* path =
      verb->add_option("case", options->case_path, "Case file")->type_name("CASE.toml");
  add_design_options(*verb, *options);
  add_output_options(*verb, options->output, options->overwrite, options->resume);
  add_set_option(*verb, options->set_edits);
  add_threads_option(*verb, options->threads);
  verb->add_option("--only", options->only, "Run the mechanics alone")
      ->check(CLI::IsMember({"mechanics"}));
  verb->add_flag("--explain", options->explain,
                 "Say how many points it has, what they share and how long it takes, and stop");
  const auto parts = add_part_options(*verb, *options);
  for (CLI::Option* part : parts) {
    for (const char* other : {"case", "--over", "--set", "--samples", "--only", "--explain",
                              "--overwrite", "--resume"}) {
      part->excludes(verb->get_option(other));
    }
  }
  add_report_options(*verb, options->no_report, options->figures);
  add_cache_option(*verb);
  add_log_options(*verb, options->log);
  verb->callback([=, &command] {
    if (parts[0]->count() == 0 && parts[1]->count() == 0) {
      path->required();
      verb->get_option("--over")->required();
      if (path->count() == 0 || verb->get_option("--over")->count() == 0) {
        throw CLI::RequiredError("case and --over");
      }
    }
    command = *options;
  });
}

void add_cluster(CLI::App& app, Command& command) {
  auto options = std::make_shared<ClusterOptions>();
  CLI::App* verb = app.add_subcommand(
      "cluster",
      "Start a cluster for sweeps, add a worker to it, stop it (Dask, docs/clusters.md)");
  verb->add_option("action", options->action, "start, worker or stop")
      ->required()
      ->type_name("ACTION")
      ->check(CLI::IsMember({"start", "worker", "stop"}));
  verb->add_option("folder", options->folder, "Folder of the cluster, with its scheduler.json")
      ->required()
      ->type_name("FOLDER");
  verb->add_option("--workers", options->workers, "start: workers on this machine")
      ->check(whole_number_from_0)
      ->capture_default_str();
  add_threads_option(*verb, options->threads);
  verb->add_option_function<std::string>(
          "--memory",
          [options](const std::string& text) {
            options->memory = static_cast<double>(base::byte_count("--memory", text));
          },
          "Memory of a worker, such as \"8 GB\" (default: 90 % of what is free)")
      ->type_name("SIZE");
  verb->add_option("--address", options->address,
                   "start: address of this machine that the scheduler listens on; other than "
                   "127.0.0.1 only with --tls")
      ->capture_default_str();
  verb->add_flag("--tls", options->tls,
                 "start: make a key and a certificate; only who holds them can connect");
  verb->add_option("--death-timeout", options->death_timeout,
                   "worker: seconds to wait for the scheduler")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  set_when_parsed(*verb, options, command);
}

void add_fit(CLI::App& app, Command& command) {
  auto options = std::make_shared<FitOptions>();
  CLI::App* verb = app.add_subcommand(
      "fit", "Fit keys of a case to a measured current, charge or voltage: estimates with 95 % "
             "intervals, the fitted case, a figure");
  verb->add_option("case", options->case_path, "Case to start from")
      ->required()
      ->type_name("CASE.toml");
  verb->add_option("--data", options->data_path,
                   "Measurement with units in its header: time [s],current_difference [A]")
      ->required()
      ->type_name("DATA.csv");
  verb->add_option("--free", options->free,
                   "Keys to fit: coupling.coefficient,electrochemistry.diffusivity. Those that "
                   "change the mechanics cost a contact solution at every trial")
      ->required()
      ->type_name("KEY,KEY")
      ->delimiter(',')
      ->expected(1)
      ->take_all();
  verb->add_option("--column", options->column, "Signal of the data, where it holds several");
  add_output_options(*verb, options->output, options->overwrite, options->resume);
  add_set_option(*verb, options->set_edits);
  add_threads_option(*verb, options->threads);
  add_cache_option(*verb);
  add_log_options(*verb, options->log);
  set_when_parsed(*verb, options, command);
}

void add_report(CLI::App& app, Command& command) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* verb = app.add_subcommand(
      "report", "Write the report of a run or a sweep, and its figures as files");
  verb->add_option("folder", options->folder, "Folder of a run or a sweep")
      ->required()
      ->type_name("DIR");
  verb->add_flag("--figures", options->files,
                 "Every figure as PNG, SVG and PDF files too, in DIR/figures");
  verb->add_option("--figure", options->figures,
                   "Only this figure, such as fig05_shear, as PNG, SVG and PDF files; no page")
      ->expected(1)
      ->allow_extra_args(false)
      ->take_all();
  verb->add_flag(
      "--claims", options->claims,
      "Judge the claims of the paper (ionskin cite names it) for a case that is not its own too");
  add_log_options(*verb, options->log);
  set_when_parsed(*verb, options, command);
}

void add_compare(CLI::App& app, Command& command) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* verb = app.add_subcommand(
      "compare", "List the parameters, metrics and signals in which two runs differ");
  verb->add_option("first", options->first, "Folder of a run")->required()->type_name("A");
  verb->add_option("second", options->second, "Folder of a run")->required()->type_name("B");
  verb->add_option("--tolerance", options->tolerance, "Relative difference that counts as none")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  set_when_parsed(*verb, options, command);
}

void add_studio(CLI::App& app, Command& command) {
  auto options = std::make_shared<StudioOptions>();
  CLI::App* verb = app.add_subcommand(
      "studio", "Open the Studio in the browser: cases, runs and results of a folder");
  verb->add_option("folder", options->folder, "Folder with cases and results")
      ->type_name("FOLDER")
      ->capture_default_str();
  verb->add_option("--port", options->port, "Port on this machine (default: any that is free)")
      ->check(CLI::Range(0, 65535));
  verb->add_flag("--no-browser", options->no_browser, "Only print the link");
  set_when_parsed(*verb, options, command);
}

} // namespace

void add_study_verbs(CLI::App& app, Command& command) {
  add_sweep(app, command);
  add_cluster(app, command);
  add_fit(app, command);
  add_report(app, command);
  add_compare(app, command);
  add_studio(app, command);
}

} // namespace ionskin::apps
