// SPDX-License-Identifier: Apache-2.0

// Cost of Study 1 of the paper's case, by its parts.

#include "presets.hpp"

#include "ionskin/base/timers.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/mechanics/engine/sliding_contact.hpp"
#include "ionskin/mechanics/path/contact_box.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/mechanics/skin/strain_recovery.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "ionskin/parallel/task_pool.hpp"
#include "ionskin/study/store/mechanics_record.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <string>
#include <thread>
#include <time.h>
#include <vector>

namespace {

using namespace ionskin;

/// Processor time of the calling thread, or of the whole process [s].
double processor_time(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Processor time that one thread needs for some work [s].
template <class Work> double seconds_of(const Work& work) {
  const double start = processor_time(CLOCK_THREAD_CPUTIME_ID);
  work();
  return processor_time(CLOCK_THREAD_CPUTIME_ID) - start;
}

Case paper_case(const std::string& preset) {
  return read_case(std::string(IONSKIN_CASES) + "/paper.toml", {"numerics.preset=" + preset});
}

void line(const std::string& name, const std::string& value) {
  fmt::print("  {:<52} {}\n", name, value);
}

/// Measures, on one core, what is made once for a skin and its cells, and a compliance.
void measure_skin(const Case& input) {
  const MotionBox box = *mechanics::contact_box(input);
  std::shared_ptr<const mechanics::SkinModel> model;
  const double made = seconds_of([&] {
    model = std::make_shared<const mechanics::SkinModel>(
        input, mechanics::find_footprint(input, input.contact.friction, 1).footprint, box);
  });
  line("contact cells", fmt::format("{}", model->cells.count()));
  line("skin, once for all places", fmt::format("{:.3f} s", made));
  mechanics::ContactCompliance compliance(*model);
  Eigen::MatrixXd matrix;
  line("first compliance of a place across",
       fmt::format("{:.1f} ms", 1e3 * seconds_of([&] { compliance.at(box.low, matrix); })));
  const std::array<double, 2> middle{0.5 * (box.low[0] + box.high[0]), box.low[1]};
  line("compliance at the end of the path",
       fmt::format("{:.1f} ms", 1e3 * seconds_of([&] { compliance.at(box.high, matrix); })));
  line("compliance in the middle",
       fmt::format("{:.1f} ms", 1e3 * seconds_of([&] { compliance.at(middle, matrix); })));
  const mechanics::StrainRecovery recovery(model, finite_layers::all_components);
  constexpr std::size_t together = 4;
  const std::vector<std::array<double, 2>> centres(together, middle);
  const std::vector<mechanics::CellVector> forces(
      together, mechanics::CellVector(3 * model->cells.count(), 1.0));
  line("strain of a state, of 4 at once", fmt::format("{:.1f} ms", 1e3 / together * seconds_of([&] {
                                                                     recovery.at(centres, forces);
                                                                   })));
}

/// Steps of a slide at the indentation of the case, each to a place of its own, on one core.
void measure_steps(const Case& input) {
  constexpr int steps = 300;
  const MotionBox box = *mechanics::contact_box(input);
  const mechanics::SkinModel model(
      input, mechanics::find_footprint(input, input.contact.friction, 1).footprint, box);
  mechanics::ContactCompliance compliance(model);
  mechanics::SlidingContact contact(
      [&](const auto& place, auto& result) { compliance.at(place, result); }, model.cells.area,
      model.gap,
      laws::friction(input.contact.law, input.contact.friction, input.contact.parameters));
  std::vector<double> seconds;
  for (int i = 0; i <= steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    const std::array<double, 2> place{box.low[0] + part * (box.high[0] - box.low[0]), box.low[1]};
    const double time_step = i == 0 ? 0 : input.motion.slide / steps;
    seconds.push_back(seconds_of([&] {
      contact.step(time_step, place, {mechanics::LoadKind::indentation, input.motion.preload});
    }));
  }
  std::ranges::sort(seconds);
  line("step of the engine", fmt::format("median {:.2f} ms, 99 % within {:.2f} ms, worst {:.2f} ms",
                                         1e3 * seconds[steps / 2], 1e3 * seconds[steps * 99 / 100],
                                         1e3 * seconds.back()));
}

struct Total {
  double wall = 0, processor = 0;
  int states = 0;
};

/// Study 1 as far as the strain histories that Study 2 takes up.
Total measure_study(const Case& input, const std::vector<double>& frictions, int threads) {
  const double wall = base::wall_time(), processor = processor_time(CLOCK_PROCESS_CPUTIME_ID);
  mechanics::ContactOptions options;
  options.threads = threads;
  base::Timers timers;
  Total total;
  {
    const auto solutions = mechanics::solve_contact(input, frictions, options, timers);
    const base::Timers::Scope scope(timers, "strain history");
    parallel::run_tasks(solutions.size(), threads,
                        [&](std::size_t i) { study::make_mechanics_record(input, solutions[i]); });
    for (const auto& solution : solutions) {
      total.states += solution.contact_solves;
    }
  }
  total.wall = base::wall_time() - wall;
  total.processor = processor_time(CLOCK_PROCESS_CPUTIME_ID) - processor;
  for (const auto& [stage, seconds] : timers.seconds()) {
    line("  " + stage,
         fmt::format("{:.2f} s, {:.1f} ms a state", seconds, seconds * 1e3 / total.states));
  }
  return total;
}

void measure(const std::string& preset, int threads) {
  const Case input = paper_case(preset);
  fmt::print("\n{} preset, one core\n", preset);
  measure_skin(input);
  measure_steps(input);
  fmt::print("{} preset, {} cycles, {} threads\n", preset, input.motion.cycles, threads);
  std::vector<double> ten(10);
  std::iota(ten.begin(), ten.end(), 1.0);
  std::transform(ten.begin(), ten.end(), ten.begin(), [](double i) { return 0.05 * i; });
  const auto show = [](const std::string& name, const Total& total) {
    line(name, fmt::format("{:.1f} s, {:.1f} s of processors, {} states; memory so far {:.2f} GB",
                           total.wall, total.processor, total.states, base::peak_memory() * 1e-9));
  };
  show("one friction coefficient", measure_study(input, {0.3}, threads));
  show("ten friction coefficients", measure_study(input, ten, threads));
}

} // namespace

int main(int argc, char** argv) {
  for (const std::string& preset :
       presets_of("What Study 1 of the paper's case costs.", argc, argv)) {
    measure(preset, static_cast<int>(std::thread::hardware_concurrency()));
  }
}
