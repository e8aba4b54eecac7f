// SPDX-License-Identifier: Apache-2.0

// What Study 1 of the paper's case costs: machine-independent counters, seconds of one core beside
// them, and the floor, its operations at this machine's measured rate of a matrix product; of a
// step those that put the compliance of its place together.

#include "presets.hpp"

#include "ionskin/base/timers.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/linear_algebra/cholesky.hpp"
#include "ionskin/linear_algebra/dense_kernels.hpp"
#include "ionskin/mechanics/elasticity/elastic_system.hpp"
#include "ionskin/mechanics/engine/position_nodes.hpp"
#include "ionskin/mechanics/engine/sliding_contact.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/mechanics/position/factorised_skin.hpp"
#include "ionskin/mechanics/position/skin_model.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "ionskin/parallel/task_pool.hpp"
#include "ionskin/study/store/mechanics_record.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <numeric>
#include <stdlib.h>
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

/// Operations a second of a matrix product in double precision on one core.
double product_rate() {
  constexpr int size = 1200;
  const linear_algebra::KernelThreads one(1);
  linear_algebra::DenseMatrix a(size, size), b(size, size);
  std::fill(a.values.begin(), a.values.end(), 1.5);
  std::fill(b.values.begin(), b.values.end(), 0.5);
  double best = 0;
  for (int repeat = 0; repeat < 5; ++repeat) {
    const double seconds = seconds_of([&] { linear_algebra::multiply(a, b); });
    best = std::max(best, 2.0 * size * size * size / seconds);
  }
  return best;
}

Case paper_case(const std::string& preset) {
  return read_case(std::string(IONSKIN_CASES) + "/paper.toml", {"numerics.preset=" + preset});
}

void line(const std::string& name, const std::string& value) {
  fmt::print("  {:<52} {}\n", name, value);
}

/// A part of the skin, on one core. @returns its factor
std::unique_ptr<const linear_algebra::Cholesky>
measure_part(const std::string& name, const mechanics::SkinPart& part, const mesh::MeshLines& lines,
             const mechanics::ElasticSkin& skin, double rate) {
  mechanics::ElasticSystem system;
  const double assembly =
      seconds_of([&] { system = mechanics::assemble(part.space, lines, skin.law_of_row); });
  std::unique_ptr<const linear_algebra::Cholesky> factor;
  const double factorisation = seconds_of([&] {
    factor = std::make_unique<const linear_algebra::Cholesky>(part.symbolic, system.stiffness);
  });
  line(name,
       fmt::format("{} unknowns, {} in the interface", part.space.unknowns(), part.interface));
  line("  entries, operations of its factor",
       fmt::format("{:.3g}, {:.3g}", part.symbolic.factor_entries(), part.symbolic.operations()));
  line("  assembly", fmt::format("{:.2f} s", assembly));
  line("  factorisation", fmt::format("{:.2f} s, {:.1f} GFlop/s; floor {:.2f} s", factorisation,
                                      part.symbolic.operations() / factorisation * 1e-9,
                                      part.symbolic.operations() / rate));
  return factor;
}

/// One position, on one core.
void measure_position(const Case& input, double rate) {
  std::unique_ptr<mechanics::SkinModel> model;
  line("numbering and contact cells",
       fmt::format("{:.2f} s", seconds_of([&] {
                     model = std::make_unique<mechanics::SkinModel>(
                         input, mechanics::find_footprint(input, input.contact.friction, 1));
                   })));
  line("symbolic analysis, once for all positions",
       fmt::format("{:.2f} s", seconds_of([&] { model->analysis(); })));
  const mechanics::SkinParts& parts = model->analysis().parts;
  const int cells = static_cast<int>(model->cells.count());
  line("displacement unknowns", fmt::format("{}", model->space.unknowns()));
  line("contact cells", fmt::format("{}", cells));
  const auto lines = model->mesh.lines(input.slider.start);
  measure_part("part under the slider, once for all positions", *parts.inner.part,
               parts.inner_lines(model->cells, lines), *model, rate);
  double entries = parts.inner.part->symbolic.factor_entries();
  for (const mechanics::PlacedPart& placed : parts.outer) {
    measure_part("part beside it, at each position", *placed.part, parts.outer_lines(placed, lines),
                 *model, rate);
    entries += placed.part->symbolic.factor_entries();
  }
  std::unique_ptr<const mechanics::FactorisedSkin> factor;
  const double first = seconds_of(
      [&] { factor = std::make_unique<const mechanics::FactorisedSkin>(*model, lines); });
  factor.reset();
  const double next = seconds_of(
      [&] { factor = std::make_unique<const mechanics::FactorisedSkin>(*model, lines); });
  line("first position, compliance included", fmt::format("{:.2f} s", first));
  line("each further position", fmt::format("{:.2f} s", next));
  mechanics::SkinDisplacement displacement(parts);
  factor->unit_displacement(0, 0, cells, displacement);
  const double backward = seconds_of([&] { factor->unit_displacement(0, 0, cells, displacement); });
  line("displacement under a unit force, of one block",
       fmt::format("{:.1f} ms ({:.3g} operations, {:.1f} GFlop/s)", backward / cells * 1e3,
                   2 * entries, 2 * entries * cells / backward * 1e-9));
}

/// Steps of a slide at the indentation of the case, each to a place of its own, on one core.
void measure_steps(const Case& input, double rate) {
  constexpr int steps = 1000;
  const auto model = std::make_shared<const mechanics::SkinModel>(
      input, mechanics::find_footprint(input, input.contact.friction, 1));
  const MotionBox box = *mechanics::contact_box(input);
  const base::ProgressCallback none = base::no_progress;
  parallel::SharedProgress progress("mechanics", none);
  const mechanics::PositionNodes nodes(input, model, box, {}, progress);
  mechanics::SlidingContact contact(
      nodes.compliance(), model->cells.area, model->gap,
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
  const double components = 3.0 * static_cast<double>(model->cells.count());
  line("step of the engine",
       fmt::format("median {:.2f} ms, 99 % within {:.2f} ms, worst {:.2f} ms; floor {:.2f} ms",
                   1e3 * seconds[steps / 2], 1e3 * seconds[steps * 99 / 100], 1e3 * seconds.back(),
                   1e3 * 2 * static_cast<double>(nodes.compliance().modes()) * components *
                       components / rate));
}

struct Total {
  double wall = 0, processor = 0;
  int states = 0;
};

/// Study 1 as far as the strain histories that Study 2 takes up.
Total measure_study(const Case& input, const std::vector<double>& frictions, int threads,
                    base::DiskCache* cache, bool show_stages) {
  const double wall = base::wall_time(), processor = processor_time(CLOCK_PROCESS_CPUTIME_ID);
  mechanics::ContactOptions options;
  options.threads = threads;
  options.cache = cache;
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
  if (show_stages) {
    for (const auto& [stage, seconds] : timers.seconds()) {
      line("  " + stage,
           fmt::format("{:.2f} s, {:.1f} ms a state", seconds, seconds * 1e3 / total.states));
    }
  }
  return total;
}

class ScratchFolder {
public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "ionskin-bench-XXXXXX").string();
    path = mkdtemp(name.data());
  }
  ~ScratchFolder() { std::filesystem::remove_all(path); }
  std::filesystem::path path;
};

void measure(const std::string& preset, double rate, int threads) {
  const Case input = paper_case(preset);
  fmt::print("\n{} preset, one core\n", preset);
  measure_position(input, rate);
  measure_steps(input, rate);
  fmt::print("{} preset, {} cycles, {} threads\n", preset, input.motion.cycles, threads);
  const ScratchFolder folder;
  base::DiskCache cache(folder.path, 20'000'000'000u);
  std::vector<double> ten(10);
  std::iota(ten.begin(), ten.end(), 1.0);
  std::transform(ten.begin(), ten.end(), ten.begin(), [](double i) { return 0.05 * i; });
  const auto show = [](const std::string& name, const Total& total) {
    line(name, fmt::format("{:.1f} s, {:.1f} s of processors, {} states; memory so far {:.2f} GB",
                           total.wall, total.processor, total.states, base::peak_memory() * 1e-9));
  };
  show("one friction coefficient, no cache", measure_study(input, {0.3}, threads, nullptr, true));
  show("ten friction coefficients, empty cache", measure_study(input, ten, threads, &cache, true));
  show("ten friction coefficients, cached", measure_study(input, ten, threads, &cache, true));
  show("one friction coefficient, cached", measure_study(input, {0.3}, threads, &cache, true));
  for (const std::string& text : cache.take_notes()) {
    fmt::print("{}\n", text);
  }
}

} // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> presets =
      presets_of("What Study 1 of the paper's case costs.", argc, argv);
  const double rate = product_rate();
  fmt::print("matrix product on one core: {:.1f} GFlop/s\n", rate * 1e-9);
  for (const std::string& preset : presets) {
    measure(preset, rate, static_cast<int>(std::thread::hardware_concurrency()));
  }
}
