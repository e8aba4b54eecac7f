// SPDX-License-Identifier: Apache-2.0
#include "study_verbs/sweep_cost.hpp"

#include "ionskin/planning/cost_estimate.hpp"
#include "ionskin/study/sweep/sweep_mechanics.hpp"

#include <fmt/format.h>

namespace ionskin::apps {
namespace {

std::string duration(double seconds) {
  if (seconds < 90) {
    return fmt::format("{:.2g} s", seconds);
  }
  return seconds < 5400 ? fmt::format("{:.2g} min", seconds / 60)
                        : fmt::format("{:.2g} h", seconds / 3600);
}

std::string counted(std::size_t count, const std::string& thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

std::string solutions_in_words(const std::vector<study::MechanicsGroup>& groups) {
  std::size_t solutions = 0;
  for (const auto& group : groups) {
    solutions += group.solutions.size();
  }
  const std::string words = counted(solutions, "contact solution");
  return groups.size() < solutions ? words + " that share " + counted(groups.size(), "skin")
                                   : words;
}

} // namespace

std::string sweep_cost(const study::SweepPlan& plan, bool both_studies, int threads,
                       double report_seconds) {
  const auto groups = study::mechanics_groups(plan.points);
  const std::string points = counted(plan.points.size(), "point");
  if (groups.empty()) {
    return points + (plan.points.front().input.strain.kind == StrainSourceKind::prescribed
                         ? ", no contact to solve"
                         : ", no contact to solve; the time follows from the strain file");
  }
  double seconds = report_seconds;
  for (const auto& group : groups) {
    const planning::CostEstimate cost =
        planning::estimate_cost(plan.points[group.first_point()].input, threads);
    seconds += cost.mechanics_seconds +
               cost.further_seconds * static_cast<double>(group.solutions.size() - 1);
  }
  if (both_studies) {
    seconds += planning::estimate_cost(plan.points.front().input, threads).ion_seconds *
               static_cast<double>(plan.points.size());
  }
  return fmt::format("{}, {}; about {} with {}", points, solutions_in_words(groups),
                     duration(seconds), counted(static_cast<std::size_t>(threads), "thread"));
}

} // namespace ionskin::apps
