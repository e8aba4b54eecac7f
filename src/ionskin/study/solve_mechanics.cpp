// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/solve_mechanics.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/mechanics/find_footprint.hpp"
#include "ionskin/study/mechanics_error_estimate.hpp"
#include "ionskin/study/read_out.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace ionskin::study {
namespace {

constexpr std::string_view companion_activity = "mechanics on a coarser mesh";

using Solutions = std::vector<mechanics::ContactSolution>;

/// A run keeps its results where their error cannot be estimated; then `problem` says why.
Solutions solve_companion(const Case& input, const std::vector<double>& frictions,
                          const mechanics::ContactOptions& options, std::string& problem) {
  mechanics::ContactOptions coarser = options;
  coarser.progress = [&options](std::string_view activity, double fraction) {
    options.progress(activity == "mechanics" ? companion_activity : activity, fraction);
  };
  base::Timers parts; // of the companion, which counts as one stage
  try {
    return mechanics::solve_contact(companion_case(input), frictions, coarser, parts);
  } catch (const SolverError& error) {
    problem = error.what();
  } catch (const UserError& error) { // its mesh does not fit beside the slider
    problem = error.what();
  }
  return {};
}

} // namespace

std::vector<SolvedMechanics> solve_mechanics(const Case& input,
                                             const std::vector<double>& frictions,
                                             const mechanics::ContactOptions& options,
                                             base::Timers& timers) {
  mechanics::ContactOptions both = options;
  if (!both.footprint) {
    const base::Timers::Scope scope(timers, "mechanics: footprint");
    both.footprint =
        mechanics::find_footprint(input, frictions.front(), options.threads, options.progress);
  }
  std::string problem;
  Solutions companions;
  {
    const base::Timers::Scope scope(timers, "mechanics: companion");
    options.progress(companion_activity, 0.0);
    companions = solve_companion(input, frictions, both, problem);
  }
  options.progress("mechanics", 0.0);
  Solutions solutions = mechanics::solve_contact(input, frictions, both, timers);
  std::vector<SolvedMechanics> solved;
  for (std::size_t i = 0; i < frictions.size(); ++i) {
    solved.push_back({std::move(solutions[i]), std::nullopt});
    if (companions.empty()) {
      solved.back().contact.warnings.push_back(
          "The error of the mechanics is not estimated: on a mesh of twice the size " + problem +
          ".");
    } else {
      solved.back().companion = std::move(companions[i]);
    }
  }
  return solved;
}

MechanicsRecord record_mechanics(const Case& input, const SolvedMechanics& solved, int threads) {
  MechanicsRecord record = make_mechanics_record(input, solved.contact);
  if (solved.companion) {
    const Case companion = companion_case(input);
    record.companion_metrics =
        read_out_mechanics(companion, make_mechanics_record(companion, *solved.companion), threads)
            .metrics;
  }
  return record;
}

} // namespace ionskin::study
