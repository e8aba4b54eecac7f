// SPDX-License-Identifier: Apache-2.0

// How long a step of a reduced skin takes, over 100,000 steps of random strokes within its range,
// and the errors that its file states: build/benchmarks/live skin.live

#include "ionskin/base/error.hpp"
#include "ionskin/live/skin.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <random>

int main(int argc, char** argv) {
  using namespace ionskin::live;
  std::string path;
  std::size_t steps = 100000;
  double rate = 1000;
  CLI::App app{"Latency of a reduced skin"};
  app.add_option("file", path)->required();
  app.add_option("--steps", steps);
  app.add_option("--rate", rate, "Steps a second of the skin's own time")
      ->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  try {
    const SkinData data = read_skin(path);
    Skin skin(data);
    std::vector<double> signals(skin.names().size()), milliseconds;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> share(0, 1);
    std::array<double, 2> at = data.lowest_place, to = at;
    double force = 0, to_force = 0;
    std::size_t rough = 0;
    for (std::size_t i = 0; i < steps; ++i) {
      // One way in twenty ends in the air.
      const double way = std::hypot(to[0] - at[0], to[1] - at[1]), travel = data.fastest / rate;
      if (way <= travel) {
        at = to;
        for (std::size_t d = 0; d < 2; ++d) {
          to[d] =
              data.lowest_place[d] + share(random) * (data.highest_place[d] - data.lowest_place[d]);
        }
        to_force = share(random) < 0.05 ? 0 : (0.15 + 0.85 * share(random)) * data.heaviest_force;
      } else {
        for (std::size_t d = 0; d < 2; ++d) {
          at[d] += (to[d] - at[d]) * travel / way;
        }
      }
      force += 0.01 * (to_force - force);
      const double load = force < 0.05 * data.heaviest_force ? 0 : force;
      const auto begin = std::chrono::steady_clock::now();
      rough += skin.step(static_cast<double>(i) / rate, at, true, load, signals) & flag::unconverged
                   ? 1
                   : 0;
      milliseconds.push_back(
          std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
              .count());
    }
    std::ranges::sort(milliseconds);
    double load = 0;
    getloadavg(&load, 1);
    fmt::print("{} cells, {} taxels, {} steps: median {:.3f} ms, p99 {:.3f} ms, worst {:.3f} ms; "
               "{} unconverged; load of the "
               "machine {:.1f}\n",
               data.area.size(), data.taxels.size(), steps, milliseconds[steps / 2],
               milliseconds[steps * 99 / 100], milliseconds.back(), rough, load);
    for (const SignalError& error : data.errors) {
      if (error.largest > 0) {
        fmt::print("{:<32} {:8.3f} % rms {:8.3f} % worst\n", error.name,
                   100 * error.rms / error.largest, 100 * error.worst / error.largest);
      }
    }
  } catch (const ionskin::UserError& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  }
  return 0;
}
