// SPDX-License-Identifier: Apache-2.0

// Cost of Study 2 of the paper's case: counters, cost per unknown and step, and the floor, the
// bytes that its vectors and factors are, each moved once per use, at this machine's measured rate.

#include "presets.hpp"

#include "ionskin/base/timers.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/electrochemistry/grid/mid_width_mirror.hpp"
#include "ionskin/electrochemistry/grid/transport_grid.hpp"
#include "ionskin/electrochemistry/ion_transport.hpp"
#include "ionskin/electrochemistry/time/problem_size.hpp"
#include "ionskin/handover/handover.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "ionskin/parallel/task_pool.hpp"
#include "ionskin/study/errors/error_estimate.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace ionskin;

// Bytes a node (two unknowns of 8 bytes; 4 in the preconditioner) that one pass over memory moves.
/// Residual: state, start, fixed charge, result. Preconditioner: see below. Linearisation: state
/// and three derivatives. Search and error: direction, new state, norms.
constexpr double preconditioner_bytes =
    24 + 2 * 32 + 24; // to modes, down and up with factors, back
constexpr double residual_bytes = 48 + preconditioner_bytes + 40 + 48 + 32;
/// Jacobian: direction, state, derivatives, result. Orthogonalisation against two vectors.
constexpr double krylov_bytes = 72 + preconditioner_bytes + 144;
/// Guesses, rates and error of both stages, fixed charge, charges of a row.
constexpr double step_bytes = 2 * 100 + 100;

/// Bytes a second of a[i] = b[i] + s c[i] on arrays beyond the caches, 24 bytes an entry; by
/// processor time, so that other work on the machine counts little.
double triad_rate(int threads) {
  constexpr std::size_t length = 8'000'000;
  std::vector<double> a(length, 0.0), b(length, 1.0), c(length, 2.0);
  const auto parts = static_cast<std::size_t>(threads);
  double best = 0;
  for (int repeat = 0; repeat < 7; ++repeat) {
    const double start = base::processor_time();
    parallel::run_tasks(parts, threads, [&](std::size_t part) {
      const std::size_t end = (part + 1) * length / parts;
      for (std::size_t i = part * length / parts; i < end; ++i) {
        a[i] = b[i] + 0.5 * c[i];
      }
    });
    best = std::max(best, threads * 24.0 * length / (base::processor_time() - start));
  }
  return best;
}

void line(const std::string& name, const std::string& value) {
  fmt::print("  {:<44} {}\n", name, value);
}

void measure(const Case& input, const history::CoreHistory& history, int threads, double rate) {
  const electrochemistry::MidWidthMirror mirror(
      electrochemistry::make_transport_grid(input, history), history);
  const double unknowns =
      static_cast<double>(electrochemistry::problem_size(input, history).unknowns) /
      mirror.copies();
  electrochemistry::IonOptions options;
  options.threads = threads;
  base::Timers timers;
  const double start = base::wall_time(), processor = base::processor_time();
  const auto ions = electrochemistry::solve_ion_transport(input, history, options, timers);
  const double seconds = base::wall_time() - start;
  const double processors = base::processor_time() - processor, each = processors / threads;
  const auto steps = static_cast<double>(ions.steps);
  const auto residuals = static_cast<double>(ions.residual_evaluations);
  const auto krylov = static_cast<double>(ions.krylov_iterations);
  fmt::print("{} threads\n", threads);
  line("unknowns that are solved for", fmt::format("{:.0f}", unknowns));
  line("steps, and taken again", fmt::format("{:.0f}, {}", steps, ions.rejected_steps));
  line("residual evaluations a step", fmt::format("{:.2f}", residuals / steps));
  line("Krylov iterations a step", fmt::format("{:.2f}", krylov / steps));
  line("wall time, of processors", fmt::format("{:.2f} s, {:.2f} s", seconds, processors));
  line("per unknown and step, by processor time",
       fmt::format("{:.0f} ns", 1e9 * each / (unknowns * steps)));
  const double bytes =
      0.5 * unknowns * (residual_bytes * residuals + krylov_bytes * krylov + step_bytes * steps);
  line("floor",
       fmt::format("{:.2f} s: {:.1f} GB at {:.1f} GB/s; processor time is {:.1f} times that",
                   bytes / rate, bytes * 1e-9, rate * 1e-9, each * rate / bytes));
  const double before = base::wall_time();
  study::MechanicsRecord given; // the parts of Study 2 alone
  given.history = history;
  study::estimate_errors(input, given, ions, study::read_out(input, given, ions, threads), threads,
                         timers);
  line("error estimate", fmt::format("{:.2f} s", base::wall_time() - before));
}

} // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> presets =
      presets_of("What Study 2 of the paper's case costs.", argc, argv);
  const int threads = static_cast<int>(std::thread::hardware_concurrency());
  for (const std::string& preset : presets) {
    const Case input =
        read_case(std::string(IONSKIN_CASES) + "/paper.toml", {"numerics.preset=" + preset});
    mechanics::ContactOptions options;
    options.threads = threads;
    base::Timers timers;
    const auto history =
        handover::build_strain_history(input, mechanics::solve_contact(input, options, timers));
    fmt::print("\n{} preset, {} cycles, ", preset, input.motion.cycles);
    measure(input, history, 1, triad_rate(1));
    if (threads > 1) {
      measure(input, history, threads, triad_rate(threads));
    }
  }
}
