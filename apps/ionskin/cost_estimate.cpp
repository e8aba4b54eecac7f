// SPDX-License-Identifier: Apache-2.0
#include "cost_estimate.hpp"

#include "ionskin/electrochemistry/problem_size.hpp"
#include "ionskin/mechanics/contact_plan.hpp"
#include "ionskin/mechanics/memory_estimate.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::apps {

namespace {

// Measured on cases/paper.toml at 45e3, 54e3 and 114e3 unknowns (coarse, standard with
// mesh_refinement 0.7, standard) on two cores with AVX2; the power fits the three within 10 %.
// Other work on the machine raised the times by up to a half.
constexpr double reference_unknowns = 1e5;
constexpr double seconds_per_position = 4.0; // processor time, factorisation and contact
constexpr double seconds_power = 1.55;
constexpr double bytes_at_rest = 0.15e9; // the program and its libraries
// Processor time per unknown of the whole core and time step, with the error estimate.
constexpr double seconds_per_ion_step = 7e-8;
constexpr double companion_share = 0.1;   // of the mechanics, on twice the mesh sizes
constexpr double seconds_of_output = 4.0; // files, figures and report

} // namespace

CostEstimate estimate_cost(const Case& input, int threads) {
  CostEstimate cost;
  cost.mechanics_unknowns = mesh::SkinMesh(input).unknowns();
  cost.positions =
      mechanics::plan_contact(input, mechanics::expected_node_counts(input)).positions.size();
  const auto ions = electrochemistry::estimate_problem_size(input);
  cost.ion_unknowns = ions.unknowns;
  cost.ion_steps = ions.steps;

  const double scale = static_cast<double>(cost.mechanics_unknowns) / reference_unknowns;
  const int at_once = std::min(threads, static_cast<int>(cost.positions));
  const double rounds = std::ceil(static_cast<double>(cost.positions) / at_once);
  cost.mechanics_seconds =
      (1 + companion_share) * rounds * seconds_per_position * std::pow(scale, seconds_power);
  cost.ion_seconds = seconds_per_ion_step * static_cast<double>(ions.unknowns) *
                     static_cast<double>(ions.steps) / threads;
  cost.seconds = cost.mechanics_seconds + cost.ion_seconds + seconds_of_output;
  const double factors = mechanics::factorisations_memory(cost.mechanics_unknowns, at_once);
  cost.memory = bytes_at_rest + std::max(factors, ions.memory);
  return cost;
}

} // namespace ionskin::apps
