// SPDX-License-Identifier: Apache-2.0
#include "ionskin/planning/cost_estimate.hpp"

#include "ionskin/electrochemistry/time/problem_size.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/mechanics/position/memory_estimate.hpp"
#include "ionskin/mechanics/position/unit_response.hpp"
#include "ionskin/mechanics/solve_stepped.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ionskin::planning {

namespace {

// Measured on two cores with AVX2: flat, rounded, cylindrical and spherical sliders of 1 mm at the
// presets coarse and standard and a flat one at fine, 29e3 to 386e3 unknowns. The power fits all
// within a factor of 1.6; other work on the machine raised the times by up to as much.
constexpr double reference_unknowns = 1e5;
constexpr double seconds_per_position = 6; // processor time, factorisation and contact
constexpr double seconds_power = 1.85;
constexpr double bytes_at_rest = 0.15e9; // the program and its libraries
// Processor time per unknown of the whole core and time step, with the error estimate.
constexpr double seconds_per_ion_step = 7e-8;
// A round slider under a force: the search for its contact, and for the indentation at every step.
constexpr double solves_of_round_force = 2.5;
constexpr double companion_share = 0.1;   // of the mechanics, on twice the mesh sizes
constexpr double own_share_of_ions = 0.6; // the rest is the error estimate's
constexpr double seconds_of_output = 4.0; // files, figures and report

/// The mesh fits the contact that a coarse solution will find. Under a force the largest contact,
/// which follows from the softest layer, may be far too large, and the mesh too small: a contact
/// smaller than its layer feels that layer alone, the highest.
mesh::SkinMesh expected_mesh(const Case& input) {
  if (const auto given = mechanics::given_footprint(input); given && !input.slider.sharp()) {
    return {input, *given};
  }
  mesh::SkinMesh largest(input);
  if (input.slider.sharp() || mesh::heaviest_load(input).force <= 0) {
    return largest;
  }
  Case of_highest = input;
  for (Layer& layer : of_highest.skin.layers) {
    layer.material = input.skin.layers.back().material;
  }
  mesh::SkinMesh smaller(input, mesh::largest_footprint(of_highest));
  return smaller.unknowns() > largest.unknowns() ? smaller : largest;
}

std::size_t contact_cells(const mesh::SkinMesh& mesh) {
  return (mesh.footprint_lines_x().size() - 1) * (mesh.footprint_lines_y().size() - 1);
}

/// Responses to unit forces at the positions of the path, which are kept until its history is
/// made wherever they are kept at all [bytes].
double response_memory(const mesh::SkinMesh& mesh, const CostEstimate& cost) {
  const auto [nx, ny, nz] = mesh.elements();
  const auto [bottom, top] = mesh.core_z();
  const double lattice = 3.0 * static_cast<double>((2 * nx + 1) * (2 * ny + 1)) *
                         static_cast<double>(2 * (top - bottom) + 1);
  const double components = 3.0 * static_cast<double>(cost.contact_cells);
  const bool kept =
      mechanics::responses_fit(static_cast<int>(lattice), 0, static_cast<int>(components));
  return kept ? sizeof(std::int32_t) * static_cast<double>(cost.positions) * lattice * components
              : 0;
}

/// Strains that are recovered together and those under the test load at the positions, and the
/// dense matrices of the contact at the positions that are solved at once [bytes].
double contact_memory(const mesh::SkinMesh& mesh, const CostEstimate& cost, int at_once) {
  constexpr double block_states = 48 + 48, test_states = 4; // with the patterns they combine
  constexpr double points = 8, strains = 6, matrices = 3;   // compliance, Newton's and its factor
  const auto [nx, ny, nz] = mesh.elements();
  const auto [bottom, top] = mesh.core_z();
  const double core = static_cast<double>(nx * ny * (top - bottom));
  const double states = test_states * static_cast<double>(cost.positions) + block_states;
  const double components = 3.0 * static_cast<double>(cost.contact_cells);
  return sizeof(double) *
         (states * core * points * strains + at_once * matrices * components * components);
}

double ion_seconds(const Case& input, const electrochemistry::ProblemSize& ions, int threads) {
  return (input.numerics.error_estimate ? 1 : own_share_of_ions) * seconds_per_ion_step *
         static_cast<double>(ions.unknowns) * static_cast<double>(ions.steps) / threads;
}

/// Of a case without contact.
CostEstimate estimate_ion_cost(const Case& input, int threads) {
  const auto ions = electrochemistry::estimate_problem_size(input);
  CostEstimate cost;
  cost.ion_unknowns = ions.unknowns;
  cost.ion_steps = ions.steps;
  cost.memory = bytes_at_rest + ions.memory;
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
  return cost;
}

CostEstimate estimate_cost(const Case& input, int threads,
                           const std::optional<mesh::Footprint>& found) {
  if (input.strain.kind == StrainSourceKind::prescribed) {
    return estimate_ion_cost(input, threads);
  }
  CostEstimate cost;
  const mesh::SkinMesh mesh = found ? mesh::SkinMesh(input, *found) : expected_mesh(input);
  cost.mechanics_unknowns = mesh.unknowns();
  cost.contact_cells = contact_cells(mesh);
  cost.positions = std::max<std::size_t>(1, mechanics::expected_positions(input));
  const auto ions = electrochemistry::estimate_problem_size(input);
  cost.ion_unknowns = ions.unknowns;
  cost.ion_steps = ions.steps;

  const double scale = static_cast<double>(cost.mechanics_unknowns) / reference_unknowns;
  const int at_once = std::min(threads, static_cast<int>(cost.positions));
  const double rounds = std::ceil(static_cast<double>(cost.positions) / at_once);
  const double solves =
      mesh::heaviest_load(input).force > 0 && !input.slider.sharp() ? solves_of_round_force : 1;
  const double companions = input.numerics.error_estimate ? companion_share : 0;
  cost.mechanics_seconds =
      (1 + companions) * solves * rounds * seconds_per_position * std::pow(scale, seconds_power);
  cost.ion_seconds = ion_seconds(input, ions, threads);
  cost.seconds = cost.mechanics_seconds + cost.ion_seconds + seconds_of_output;
  const double factors = mechanics::factorisations_memory(cost.mechanics_unknowns, at_once);
  cost.memory = bytes_at_rest + std::max(factors + contact_memory(mesh, cost, at_once) +
                                             response_memory(mesh, cost),
                                         ions.memory);
  return cost;
}

} // namespace ionskin::planning
