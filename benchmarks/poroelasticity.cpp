// SPDX-License-Identifier: Apache-2.0

// Cost of the law `poroelastic` in Study 2 of the paper's case: processor time of the water's part
// against that of the rest, and its memory.

#include "presets.hpp"

#include "ionskin/base/timers.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/electrochemistry/coupling/driving_channel.hpp"
#include "ionskin/electrochemistry/grid/mid_width_mirror.hpp"
#include "ionskin/electrochemistry/grid/transport_grid.hpp"
#include "ionskin/electrochemistry/ion_transport.hpp"
#include "ionskin/handover/handover.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "ionskin/poroelasticity/streaming_drive.hpp"

#include <fmt/core.h>

#include <string>
#include <thread>

namespace {

using namespace ionskin;

/// Evaluations of the drive in a time step: both implicit stages.
constexpr double evaluations_per_step = 2;

/// Processor time of moving the water to one more instant and reading the drive [s].
double seconds_of_drive(const Case& input, const history::CoreHistory& history,
                        std::size_t& values) {
  const electrochemistry::MidWidthMirror mirror(
      electrochemistry::make_transport_grid(input, history), history);
  const auto& grid = mirror.solved_grid();
  poroelasticity::StreamingDrive drive(
      input, history, electrochemistry::driving_channel(input.coupling.law, history), grid.x_edges,
      grid.y_edges, grid.z_nodes);
  drive.start(history.time.front());
  constexpr int repeats = 200;
  const double start = base::processor_time();
  for (int i = 1; i <= repeats; ++i) {
    drive.evaluate(history.time.front() + i * history.duration() / repeats);
    drive.accept({});
  }
  values = drive.pressure().size();
  return (base::processor_time() - start) / repeats;
}

void measure(const Case& input, const history::CoreHistory& history) {
  base::Timers timers;
  const double start = base::processor_time();
  const auto ions = electrochemistry::solve_ion_transport(input, history, {}, timers);
  const double whole = base::processor_time() - start;
  std::size_t values = 0;
  const double water = evaluations_per_step *
                       static_cast<double>(ions.steps + ions.rejected_steps) *
                       seconds_of_drive(input, history, values);
  fmt::print("  {} steps, processor time {:.2f} s, of the water {:.2f} s: adds {:.0f} %\n",
             ions.steps, whole, water, 100 * water / (whole - water));
  // Two states of two fields, and five fields beside them.
  fmt::print("  pressure at {} places: about {:.1f} MB\n", values,
             9.0 * 8.0 * static_cast<double>(values) * 1e-6);
}

} // namespace

int main(int argc, char** argv) {
  for (const std::string& preset :
       presets_of("What the law poroelastic adds to Study 2.", argc, argv)) {
    const Case input =
        read_case(std::string(IONSKIN_CASES) + "/paper/water.toml", {"numerics.preset=" + preset});
    mechanics::ContactOptions options;
    options.threads = static_cast<int>(std::thread::hardware_concurrency());
    base::Timers timers;
    const auto history =
        handover::build_strain_history(input, mechanics::solve_contact(input, options, timers));
    fmt::print("{} preset\n", preset);
    measure(input, history);
  }
  return 0;
}
