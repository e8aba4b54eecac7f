// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/time_grid.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::electrochemistry {
namespace {

double longest_step(Preset preset) {
  switch (preset) {
  case Preset::coarse:
    return 0.1;
  case Preset::standard:
    return 0.05;
  case Preset::fine:
    return 0.025;
  }
  return 0.025;
}

double step_growth(Preset preset) {
  switch (preset) {
  case Preset::coarse:
    return 1.5;
  case Preset::standard:
    return 1.35;
  case Preset::fine:
    return 1.2;
  }
  return 1.2;
}

/// Instants closer than this are one.
double same_instant(const strain::StrainHistory& history) {
  return 1e-12 * history.duration();
}

/// Samples and wanted instants in order; a wanted instant next to a sample is that sample.
std::vector<double> landings(const strain::StrainHistory& history,
                             const std::vector<double>& wanted) {
  std::vector<double> all = history.time;
  const double resolution = same_instant(history);
  for (const double instant : wanted) {
    const double inside = std::clamp(instant, history.time.front(), history.time.back());
    const bool known = std::any_of(history.time.begin(), history.time.end(), [&](double sample) {
      return std::abs(sample - inside) <= resolution;
    });
    if (!known) {
      all.push_back(inside);
    }
  }
  std::sort(all.begin(), all.end());
  const auto same = [resolution](double a, double b) { return b - a <= resolution; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

} // namespace

StepRule step_rule(const Numerics& numerics, const DerivedScales& scales) {
  const double refinement = numerics.time_refinement;
  return {std::min(1e-5, scales.relaxation_time / 500.0) / refinement,
          1.0 + (step_growth(numerics.preset) - 1.0) / refinement,
          std::min(longest_step(numerics.preset),
                   longest_step(numerics.preset) / 0.05 * scales.slow_time / 15.0) /
              refinement};
}

std::vector<double> make_time_grid(const strain::StrainHistory& history, const StepRule& rule,
                                   const std::vector<double>& wanted) {
  const double resolution = same_instant(history);
  const auto is_event = [&](double instant) {
    return std::any_of(history.event_time.begin(), history.event_time.end(),
                       [&](double event) { return std::abs(event - instant) <= resolution; });
  };
  const std::vector<double> targets = landings(history, wanted);
  std::vector<double> ends{targets.front()};
  double step = rule.first;
  for (std::size_t i = 1; i < targets.size(); ++i) {
    const double target = targets[i];
    while (true) {
      const double rest = target - ends.back();
      const double next = std::min(step, rule.longest);
      step = next * rule.growth;
      if (next >= 0.999 * rest) {
        break;
      }
      // Two equal steps rather than a long one and a sliver.
      ends.push_back(ends.back() + (2.0 * next > rest ? 0.5 * rest : next));
    }
    ends.push_back(target);
    if (is_event(target)) {
      step = rule.first;
    }
  }
  return ends;
}

} // namespace ionskin::electrochemistry
