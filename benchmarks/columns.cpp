// SPDX-License-Identifier: Apache-2.0

// Cost of four times the columns in a step of Study 2: the paper's case and the same skin four
// times as wide, one cycle each, in turns, so that what else the machine does falls on both.

#include "presets.hpp"

#include "ionskin/base/timers.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/electrochemistry/ion_transport.hpp"
#include "ionskin/handover/handover.hpp"
#include "ionskin/mechanics/solve_contact.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

using namespace ionskin;

constexpr std::size_t turns = 7;

struct RubbedSkin {
  Case input;
  history::CoreHistory history;
};

/// The shear of the coarse preset serves: the cost of a step does not depend on the mechanics.
RubbedSkin skin_of(const std::string& preset, const std::vector<std::string>& edits, int threads) {
  const std::string file = std::string(IONSKIN_CASES) + "/paper.toml";
  std::vector<std::string> all = edits;
  all.insert(all.end(), {"motion.cycles=1", "numerics.preset=coarse"});
  const Case coarse = read_case(file, all);
  all.back() = "numerics.preset=" + preset;
  mechanics::ContactOptions options;
  options.threads = threads;
  base::Timers timers;
  return {read_case(file, all), handover::build_strain_history(
                                    coarse, mechanics::solve_contact(coarse, options, timers))};
}

struct Cost {
  double wall = 0, processors = 0; ///< a step [s]
};

Cost cost(const RubbedSkin& skin, int threads) {
  electrochemistry::IonOptions options;
  options.threads = threads;
  base::Timers timers;
  const double wall = base::wall_time(), processors = base::processor_time();
  const auto ions =
      electrochemistry::solve_ion_transport(skin.input, skin.history, options, timers);
  const auto steps = static_cast<double>(ions.steps);
  return {(base::wall_time() - wall) / steps, (base::processor_time() - processors) / steps};
}

double median(std::vector<Cost> costs, double Cost::*member) {
  std::ranges::nth_element(costs, costs.begin() + turns / 2, {}, member);
  return costs[turns / 2].*member;
}

void compare(const std::array<RubbedSkin, 2>& skins, int threads) {
  std::array<std::vector<Cost>, 2> costs;
  for (std::size_t turn = 0; turn < turns; ++turn) {
    for (std::size_t i = 0; i < 2; ++i) {
      costs[i].push_back(cost(skins[i], threads));
    }
  }
  fmt::print("  {} threads, medians of {} turns\n", threads, turns);
  for (const auto& [name, member] :
       {std::pair{"wall time", &Cost::wall}, std::pair{"time of processors", &Cost::processors}}) {
    const double narrow = median(costs[0], member), wide = median(costs[1], member);
    fmt::print(
        "    {:<20} {:6.2f} ms a step, {:6.2f} ms with four times the columns: {:.2f} times\n",
        name, 1e3 * narrow, 1e3 * wide, wide / narrow);
  }
}

} // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> presets =
      presets_of("What four times the columns cost a step of Study 2.", argc, argv);
  const int threads = static_cast<int>(std::thread::hardware_concurrency());
  for (const std::string& preset : presets) {
    const std::array<RubbedSkin, 2> skins{
        skin_of(preset, {}, threads),
        skin_of(preset, {"skin.width=8 mm", "slider.start=[\"4.5 mm\", \"4 mm\"]"}, threads)};
    fmt::print("{} preset\n", preset);
    compare(skins, 1);
    if (threads > 1) {
      compare(skins, threads);
    }
  }
}
