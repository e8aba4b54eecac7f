// SPDX-License-Identifier: Apache-2.0

// The verbs that compute; started by `ionskin` with the same arguments.

#include "command_line/command_line.hpp"
#include "command_line/guard.hpp"
#include "study_verbs/check_solved.hpp"
#include "study_verbs/fit.hpp"
#include "study_verbs/impedance.hpp"
#include "study_verbs/python_verbs.hpp"
#include "study_verbs/run.hpp"
#include "study_verbs/sweep.hpp"
#include "study_verbs/trial_verbs.hpp"
#include "terminal/terminal.hpp"

#include "ionskin/base/system/free_memory.hpp"

int main(int argc, char** argv) {
  using namespace ionskin::apps;
  return guarded([&]() -> int {
    require_vector_instructions();
    ionskin::base::keep_freed_blocks();
    int exit_code = 0;
    const auto command = parse_command_line(argc, argv, exit_code);
    if (!command) {
      return exit_code;
    }
    const std::string command_text = command_as_typed(argc, argv);
    if (const auto* check_options = std::get_if<CheckOptions>(&*command)) {
      return check_with_solver(*check_options);
    }
    if (const auto* run_options = std::get_if<RunOptions>(&*command)) {
      return run(*run_options, command_text);
    }
    if (const auto* impedance_options = std::get_if<ImpedanceOptions>(&*command)) {
      return impedance(*impedance_options, command_text);
    }
    if (const auto* sweep_options = std::get_if<SweepOptions>(&*command)) {
      return sweep(*sweep_options, command_text);
    }
    if (const auto* cluster_options = std::get_if<ClusterOptions>(&*command)) {
      return cluster(*cluster_options);
    }
    if (const auto* fit_options = std::get_if<FitOptions>(&*command)) {
      return fit(*fit_options, command_text);
    }
    if (const auto* uncertainty_options = std::get_if<UncertaintyOptions>(&*command)) {
      return uncertainty(*uncertainty_options);
    }
    if (const auto* design_options = std::get_if<DesignOptions>(&*command)) {
      return design(*design_options);
    }
    if (const auto* generate_options = std::get_if<GenerateOptions>(&*command)) {
      return generate(*generate_options);
    }
    if (const auto* motion_options = std::get_if<MotionOptions>(&*command)) {
      return motion(*motion_options);
    }
    if (const auto* report_options = std::get_if<ReportOptions>(&*command)) {
      return report(*report_options);
    }
    return compare(std::get<CompareOptions>(*command));
  });
}
