// SPDX-License-Identifier: Apache-2.0

// Distance of a reduced skin from the full model of its own case on random touches that neither its
// training nor its validation had, how many of them keep the errors that its file states, and which
// of them has the largest rms error:
// build/benchmarks/live_accuracy skin.live [--touches 100]

#include "ionskin/base/error.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/live/training/stated_errors.hpp"
#include "ionskin/live/training/touch_range.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>
#include <vector>

namespace {

using namespace ionskin::live;

double covered(const std::vector<double>& errors, double stated) {
  const auto below = std::ranges::count_if(errors, [&](double error) { return error <= stated; });
  return 100.0 * static_cast<double>(below) / static_cast<double>(errors.size());
}

void print(const std::vector<TouchErrors>& errors, const SkinData& data) {
  fmt::print("{:<39}{:>9}{:>9}{:>12}{:>12}{:>11}{:>11}{:>7}\n", "% of the largest value", "rms",
             "worst", "stated rms", "stated worst", "keep rms", "keep worst", "touch");
  for (const TouchErrors& signal : errors) {
    const auto stated = std::ranges::find_if(data.errors, [&](const SignalError& error) {
      return error.name == signal.name && error.event == signal.event;
    });
    if (signal.largest == 0 || stated == data.errors.end()) {
      continue;
    }
    double square = 0;
    for (const double rms : signal.rms) {
      square += rms * rms;
    }
    const double percent = 100 / signal.largest;
    fmt::print("{:<28}{:<11}{:9.3f}{:9.3f}{:12.3f}{:12.3f}{:9.0f} %{:9.0f} %{:7}\n", signal.name,
               signal.event, percent * std::sqrt(square / static_cast<double>(signal.rms.size())),
               percent * *std::ranges::max_element(signal.worst), percent * stated->rms,
               percent * stated->worst, covered(signal.rms, stated->rms),
               covered(signal.worst, stated->worst),
               std::ranges::max_element(signal.rms) - signal.rms.begin());
  }
}

} // namespace

int main(int argc, char** argv) {
  std::string path;
  std::size_t touches = 100;
  std::uint64_t seed = 1000000;
  int threads = 1;
  CLI::App app{"Accuracy of a reduced skin"};
  app.add_option("file", path)->required();
  app.add_option("--touches", touches)->check(CLI::Range(1, 10000))->capture_default_str();
  app.add_option("--seed", seed)->capture_default_str();
  app.add_option("--threads", threads)->check(CLI::PositiveNumber)->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    const SkinData data = read_skin(path);
    const ionskin::Case input = ionskin::read_case_text(data.case_text, path).input;
    TrainingOptions options;
    options.threads = threads;
    TouchRange range = touch_range(input);
    range.steepest = data.steepest;
    range.fastest_turn = data.fastest_turn;
    range.any_yaw = turns_underside(data);
    const auto footprint =
        full_run(input, random_touches(range, 1, seed), {}, options).contact.mesh.footprint();
    print(errors_on_touches(data, input, range, touches, seed, footprint, options,
                            [&](const ComparedTouches& compared) {
                              fmt::print(stderr, "{} of {} touches, {:.0f} s of processor time\n",
                                         compared.count, touches,
                                         static_cast<double>(std::clock()) / CLOCKS_PER_SEC);
                            }),
          data);
  } catch (const ionskin::UserError& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  }
  return 0;
}
