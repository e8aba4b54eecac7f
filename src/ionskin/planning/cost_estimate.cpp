// SPDX-License-Identifier: Apache-2.0
#include "ionskin/planning/cost_estimate.hpp"

#include "ionskin/electrochemistry/time/problem_size.hpp"
#include "ionskin/planning/mechanics_cost.hpp"
#include "ionskin/planning/output_size.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ionskin::planning {

namespace {

constexpr double bytes_at_rest = 0.1e9; // memory of the idle program and its libraries
// Processor time of Study 2 per unknown and time step, with the error estimate [s].
constexpr double seconds_per_ion_step = 7e-8;
constexpr double own_share_of_ions = 0.6; // share of Study 2 without the error estimate
constexpr double seconds_of_output = 1.0; // files, and half a second for the report page

double ion_seconds(const Case& input, const electrochemistry::ProblemSize& ions, int threads) {
  return (input.numerics.error_estimate ? 1 : own_share_of_ions) * seconds_per_ion_step *
         static_cast<double>(ions.unknowns) * static_cast<double>(ions.steps) / threads;
}

/// Cost of a case with a prescribed load, which has no contact.
CostEstimate estimate_ion_cost(const Case& input, int threads) {
  const auto ions = electrochemistry::estimate_problem_size(input);
  CostEstimate cost;
  cost.ion_unknowns = ions.unknowns;
  cost.ion_steps = ions.steps;
  cost.memory = bytes_at_rest + ions.memory;
  cost.output = output_size(input, ions.unknowns, ions.steps);
  cost.ion_seconds = ion_seconds(input, ions, threads);
  cost.seconds = cost.ion_seconds + seconds_of_output;
  return cost;
}

} // namespace

CostEstimate estimate_cost(const Case& input, const history::CoreHistory& given, int threads) {
  const auto ions = electrochemistry::problem_size(input, given);
  CostEstimate cost;
  cost.ion_unknowns = ions.unknowns;
  cost.ion_steps = ions.steps;
  cost.ion_seconds = ion_seconds(input, ions, threads);
  cost.seconds = cost.ion_seconds + seconds_of_output;
  double history = 0;
  for (const history::HistoryChannel& channel : given.channels) {
    history += static_cast<double>(channel.samples.size() * given.grid.values() * sizeof(double));
  }
  cost.memory = bytes_at_rest + history + ions.memory;
  cost.output = output_size(input, ions.unknowns, ions.steps);
  return cost;
}

CostEstimate estimate_cost(const Case& input, int threads,
                           const std::optional<mesh::Footprint>& found) {
  if (input.strain.kind == StrainSourceKind::prescribed) {
    return estimate_ion_cost(input, threads);
  }
  const MechanicsCost mechanics = estimate_mechanics_cost(input, threads, found);
  const auto ions = electrochemistry::estimate_problem_size(input);
  CostEstimate cost;
  cost.contact_cells = mechanics.contact_cells;
  cost.contact_steps = mechanics.steps;
  cost.ion_unknowns = ions.unknowns;
  cost.ion_steps = ions.steps;
  cost.mechanics_seconds = mechanics.seconds;
  cost.further_seconds = mechanics.further_seconds;
  cost.ion_seconds = ion_seconds(input, ions, threads);
  cost.seconds = cost.mechanics_seconds + cost.ion_seconds + seconds_of_output;
  cost.memory = bytes_at_rest + std::max(mechanics.memory, mechanics.histories + ions.memory);
  cost.output = output_size(input, ions.unknowns, ions.steps);
  return cost;
}

std::string announced_time(const Case& input, const CostEstimate& cost) {
  constexpr double worth_telling = 300;
  constexpr std::size_t many_rows = 200;
  if (!(cost.seconds > worth_telling)) {
    return "";
  }
  const double minutes = cost.seconds / 60, hour = 60;
  const std::string time =
      "the run will take about " + (minutes < 2 * hour ? fmt::format("{:.0f} min", minutes)
                                                       : fmt::format("{:.0f} h", minutes / hour));
  if (const std::size_t rows = input.motion.waypoints.size(); rows > many_rows) {
    return fmt::format("{}: its path has {} rows. A path with fewer rows takes less; "
                       "`ionskin motion --rate 100Hz` makes one of a recording",
                       time, rows);
  }
  return fmt::format("{}; {} takes less", time,
                     input.numerics.preset == Preset::coarse ? "a smaller numerics.mesh_refinement"
                                                             : "numerics.preset = \"coarse\"");
}

} // namespace ionskin::planning
