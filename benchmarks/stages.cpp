// SPDX-License-Identifier: Apache-2.0

// Wall time of each stage of the paper's case, with machine-independent counters beside it.
// Arguments of a benchmark: preset (0 coarse, 1 standard) and threads.

#include "ionskin/base/timers.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/electrochemistry/ion_transport.hpp"
#include "ionskin/electrochemistry/time/problem_size.hpp"
#include "ionskin/handover/handover.hpp"
#include "ionskin/mechanics/solve_contact.hpp"

#include <benchmark/benchmark.h>

#include <map>

namespace {

using namespace ionskin;

Case paper_case(const benchmark::State& state) {
  const std::string preset = state.range(0) == 0 ? "coarse" : "standard";
  return read_case(std::string(IONSKIN_CASES) + "/paper.toml", {"numerics.preset=" + preset});
}

int threads(const benchmark::State& state) {
  return static_cast<int>(state.range(1));
}

mechanics::ContactSolution solve_mechanics(const Case& input, int thread_count) {
  mechanics::ContactOptions options;
  options.threads = thread_count;
  base::Timers timers;
  return mechanics::solve_contact(input, options, timers);
}

/// The history of one preset, made once for the benchmarks behind it.
const history::CoreHistory& history_of(const Case& input, int thread_count) {
  static std::map<Preset, history::CoreHistory> histories;
  auto found = histories.find(input.numerics.preset);
  if (found == histories.end()) {
    const auto contact = solve_mechanics(input, thread_count);
    found = histories.emplace(input.numerics.preset, handover::build_strain_history(input, contact))
                .first;
  }
  return found->second;
}

void contact(benchmark::State& state) {
  const Case input = paper_case(state);
  for (auto _ : state) {
    const auto solution = solve_mechanics(input, threads(state));
    state.counters["contact_solves"] = solution.contact_solves;
  }
  state.counters["peak_memory_GB"] = base::peak_memory() / 1e9;
}

void ion_transport(benchmark::State& state) {
  const Case input = paper_case(state);
  const auto& history = history_of(input, threads(state));
  const double unknowns =
      static_cast<double>(electrochemistry::problem_size(input, history).unknowns);
  electrochemistry::IonOptions options;
  options.threads = threads(state);
  for (auto _ : state) {
    base::Timers timers;
    const auto ions = electrochemistry::solve_ion_transport(input, history, options, timers);
    state.counters["unknowns"] = unknowns;
    state.counters["steps"] = static_cast<double>(ions.steps);
    state.counters["residuals"] = static_cast<double>(ions.residual_evaluations);
    state.counters["krylov"] = static_cast<double>(ions.krylov_iterations);
    state.counters["unknown_steps/s"] = benchmark::Counter(
        unknowns * static_cast<double>(ions.steps), benchmark::Counter::kIsIterationInvariantRate);
  }
}

} // namespace

BENCHMARK(contact)
    ->ArgNames({"preset", "threads"})
    ->ArgsProduct({{0, 1}, {1, 2}})
    ->Unit(benchmark::kSecond)
    ->UseRealTime()
    ->Iterations(1);
BENCHMARK(ion_transport)
    ->ArgNames({"preset", "threads"})
    ->ArgsProduct({{0, 1}, {1, 2}})
    ->Unit(benchmark::kSecond)
    ->UseRealTime()
    ->Iterations(1);
BENCHMARK_MAIN();
