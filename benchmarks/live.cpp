// SPDX-License-Identifier: Apache-2.0

// Time of a step of a reduced skin, by the clock and in processor time, over 100,000 steps of
// random strokes within its range; of a landing under a force within one step; how many touches of
// 1 s all threads step in a minute; and the errors that its file states:
// build/benchmarks/live skin.live

#include "ionskin/base/error.hpp"
#include "ionskin/live/skin.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <random>
#include <thread>

namespace {

using namespace ionskin::live;

constexpr double least_speed = 0.1, least_load = 0.15; // over the fastest and the heaviest
constexpr double in_air = 0.05, resting = 0.2;         // of the ways

/// Strokes from place to place, some of which end in the air or rest for a while, under a force
/// that follows within some 0.1 s.
class RandomStrokes {
public:
  RandomStrokes(const SkinData& data, double rate, unsigned seed)
      : data_(data), rate_(rate), random_(seed), at(data.lowest_place), to_(at) {}

  void next() {
    const double way = std::hypot(to_[0] - at[0], to_[1] - at[1]);
    if (rest_ > 0) {
      --rest_;
    } else if (way <= travel_) {
      at = to_;
      turn();
    } else {
      for (std::size_t d = 0; d < 2; ++d) {
        at[d] += (to_[d] - at[d]) * travel_ / way;
      }
    }
    wanted_ += 10 / rate_ * (to_force_ - wanted_);
    force = wanted_ < 0.05 * data_.heaviest_force ? 0 : wanted_;
  }

private:
  double share() { return std::uniform_real_distribution<double>(0, 1)(random_); }
  void turn() {
    for (std::size_t d = 0; d < 2; ++d) {
      to_[d] = data_.lowest_place[d] + share() * (data_.highest_place[d] - data_.lowest_place[d]);
    }
    travel_ = (least_speed + (1 - least_speed) * share()) * data_.fastest / rate_;
    to_force_ =
        share() < in_air ? 0 : (least_load + (1 - least_load) * share()) * data_.heaviest_force;
    rest_ = share() < resting ? static_cast<int>(0.3 * rate_) : 0;
  }

  const SkinData& data_;
  double rate_;
  std::mt19937 random_;

public:
  std::array<double, 2> at;
  double force = 0;

private:
  std::array<double, 2> to_;
  double travel_ = 0, wanted_ = 0, to_force_ = 0;
  int rest_ = 0;
};

double processor_milliseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

void print_times(const char* clock, std::vector<double>& milliseconds) {
  std::ranges::sort(milliseconds);
  fmt::print("  {:<15} median {:.3f} ms, p99 {:.3f} ms, worst {:.3f} ms\n", clock,
             milliseconds[milliseconds.size() / 2], milliseconds[milliseconds.size() * 99 / 100],
             milliseconds.back());
}

void time_steps(const SkinData& data, std::size_t steps, double rate) {
  Skin skin(data);
  std::vector<double> signals(skin.names().size()), by_clock, by_processor;
  RandomStrokes strokes(data, rate, 1);
  std::size_t rough = 0;
  for (std::size_t i = 0; i < steps; ++i) {
    strokes.next();
    const auto begin = std::chrono::steady_clock::now();
    const double before = processor_milliseconds();
    const std::uint32_t flags =
        skin.step(static_cast<double>(i) / rate, strokes.at, true, strokes.force, signals);
    by_processor.push_back(processor_milliseconds() - before);
    by_clock.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
            .count());
    rough += flags & flag::unconverged ? 1 : 0;
  }
  double load = 0;
  getloadavg(&load, 1);
  fmt::print("{} cells, {} taxels, {} steps, {} of them unconverged; load of the machine {:.1f}\n",
             data.area.size(), data.taxels.size(), steps, rough, load);
  print_times("by the clock", by_clock);
  print_times("processor time", by_processor);
}

/// Median processor time of a landing within one step, under shares of the heaviest force, at
/// places along the diagonal of the range.
void time_landings(const SkinData& data) {
  constexpr std::size_t places = 21;
  fmt::print("landing within one step, processor time:");
  for (const double share : {0.05, 0.2, 0.5, 1.0}) {
    std::vector<double> milliseconds;
    for (std::size_t place = 0; place < places; ++place) {
      const double along = static_cast<double>(place) / (places - 1);
      const std::array<double, 2> at{std::lerp(data.lowest_place[0], data.highest_place[0], along),
                                     std::lerp(data.lowest_place[1], data.highest_place[1], along)};
      Skin skin(data);
      std::vector<double> signals(skin.names().size());
      skin.step(0, at, true, 0, signals);
      const double before = processor_milliseconds();
      skin.step(1e-3, at, true, share * data.heaviest_force, signals);
      milliseconds.push_back(processor_milliseconds() - before);
    }
    std::ranges::nth_element(milliseconds, milliseconds.begin() + places / 2);
    fmt::print(" {:.2f} ms under {:.0f} % of the heaviest force{}", milliseconds[places / 2],
               100 * share, share < 1 ? "," : "\n");
  }
}

/// Touches of 1 s, each by a skin of its own that starts at rest.
void time_batch(const SkinData& data, std::size_t threads, std::size_t touches) {
  const Skin rested(data);
  std::vector<double> processor(threads);
  const auto begin = std::chrono::steady_clock::now();
  std::vector<std::thread> team;
  for (std::size_t thread = 0; thread < threads; ++thread) {
    team.emplace_back([&, thread] {
      constexpr double rate = 1000;
      for (std::size_t touch = thread; touch < touches; touch += threads) {
        Skin skin = rested;
        std::vector<double> signals(skin.names().size());
        RandomStrokes strokes(data, rate, static_cast<unsigned>(touch));
        for (std::size_t i = 0; i < static_cast<std::size_t>(rate); ++i) {
          strokes.next();
          skin.step(static_cast<double>(i) / rate, strokes.at, true, strokes.force, signals);
        }
      }
      processor[thread] = processor_milliseconds();
    });
  }
  for (std::thread& thread : team) {
    thread.join();
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  double busy = 0; // of the slowest thread [s]
  for (const double milliseconds : processor) {
    busy = std::max(busy, 1e-3 * milliseconds);
  }
  const double count = static_cast<double>(touches);
  fmt::print("{} touches of 1 s on {} threads: {:.0f} a minute by the clock, {:.0f} by processor "
             "time\n",
             touches, threads, 60 * count / seconds, 60 * count / busy);
}

} // namespace

int main(int argc, char** argv) {
  std::string path;
  std::size_t steps = 100000, threads = 2, touches = 200;
  double rate = 1000;
  CLI::App app{"Latency and throughput of a reduced skin"};
  app.add_option("file", path)->required();
  app.add_option("--steps", steps)->check(CLI::PositiveNumber);
  app.add_option("--rate", rate, "Steps a second of the skin's own time")
      ->check(CLI::PositiveNumber);
  app.add_option("--threads", threads)->check(CLI::PositiveNumber);
  app.add_option("--touches", touches, "Of the batch")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  try {
    const SkinData data = read_skin(path);
    time_steps(data, steps, rate);
    time_landings(data);
    time_batch(data, threads, touches);
    for (const SignalError& error : data.errors) {
      if (error.largest > 0) {
        fmt::print("{:<32} {:<10} {:8.3f} % rms {:8.3f} % worst\n", error.name, error.event,
                   100 * error.rms / error.largest, 100 * error.worst / error.largest);
      }
    }
  } catch (const ionskin::UserError& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  }
  return 0;
}
