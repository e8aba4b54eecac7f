// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/solve_mechanics.hpp"

#include "ionskin/study/mechanics_error.hpp"
#include "ionskin/study/read_out.hpp"

#include <utility>

namespace ionskin::study {

std::vector<SolvedMechanics> solve_mechanics(const Case& input,
                                             const std::vector<double>& frictions,
                                             const mechanics::ContactOptions& options,
                                             base::Timers& timers) {
  mechanics::ContactOptions quiet = options;
  quiet.progress = base::no_progress;
  base::Timers companion_timers;
  std::vector<mechanics::ContactSolution> companions;
  {
    const base::Timers::Scope scope(timers, "mechanics: companion");
    companions =
        mechanics::solve_contact(companion_case(input), frictions, quiet, companion_timers);
  }
  auto solutions = mechanics::solve_contact(input, frictions, options, timers);
  std::vector<SolvedMechanics> solved;
  for (std::size_t i = 0; i < frictions.size(); ++i) {
    solved.push_back({std::move(solutions[i]), std::move(companions[i])});
  }
  return solved;
}

MechanicsRecord record_mechanics(const Case& input, const SolvedMechanics& solved, int threads) {
  MechanicsRecord record = make_mechanics_record(input, solved.contact);
  const Case companion = companion_case(input);
  record.companion_metrics =
      read_out_mechanics(companion, make_mechanics_record(companion, solved.companion), threads)
          .metrics;
  return record;
}

} // namespace ionskin::study
