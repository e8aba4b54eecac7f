// SPDX-License-Identifier: Apache-2.0
#include "ionskin/planning/mechanics_cost.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/coupling.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/handover/strain_grid.hpp"
#include "ionskin/linear_algebra/fixed_point_columns.hpp"
#include "ionskin/mechanics/companions.hpp"
#include "ionskin/mechanics/path/expected_steps.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/mechanics/position/memory_estimate.hpp"
#include "ionskin/mechanics/position/unit_response.hpp"
#include "ionskin/mechanics/solve_stepped.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

namespace ionskin::planning {
namespace {

// Processor time [s], measured with AVX2 over the random cases of `benchmarks/explained_costs.py`
// and cases/paper.toml and cases/finger.toml at coarse and standard, 15e3 to 174e3 unknowns n. The
// powers fit every factorisation within a factor of 2.4, the responses within 1.8.
double first_factorisation(double n) {
  return 6.0e-8 * std::pow(n, 1.59);
}
double further_factorisation(double n) {
  return 9.2e-8 * std::pow(n, 1.44);
}
constexpr double seconds_per_response = 1.25e-7; ///< over unknowns and cells
/// Of a step of the contact, over the square of the cells; round sliders take up to three times as
/// long, flat ones half.
constexpr double seconds_per_step = 1.5e-7, seconds_per_driven_step = 3e-7;
/// Of the strain of an instant that is kept of the path, over unknowns.
constexpr double seconds_per_strain = 1e-7;
/// Meshes on which the contact of a round slider is sought, of about the size of that which is
/// found, each at two positions.
constexpr double searched_meshes = 2;
/// Rectangles of positions that a slider on a drive is solved over: one, and often a wider one.
constexpr double passes_of_drive = 1.5;

/// The mesh fits the contact that a coarse solution will find.
mesh::SkinMesh expected_mesh(const Case& input) {
  const auto given = mechanics::given_footprint(input);
  return {input, given && !input.slider.sharp() ? *given : mesh::expected_footprint(input)};
}

/// What one mesh costs, apart from the steps along the path.
struct MeshCost {
  MeshCost(const Case& input, const mesh::SkinMesh& mesh)
      : unknowns(static_cast<double>(mesh.unknowns())),
        cells((mesh.footprint_lines_x().size() - 1) * (mesh.footprint_lines_y().size() - 1)),
        positions(std::max<std::size_t>(1, mechanics::expected_positions(input))),
        driven(input.motion.drive.given()), passes(driven ? passes_of_drive : 1) {
    lines_across =
        static_cast<double>(mechanics::expected_lines(input)[mesh.main_axis() == 0 ? 1 : 0]);
    const auto [nx, ny, nz] = mesh.elements();
    const auto [bottom, top] = mesh.core_z();
    core_elements = static_cast<double>(nx * ny * (top - bottom));
    lattice = 3.0 * static_cast<double>((2 * nx + 1) * (2 * ny + 1)) *
              static_cast<double>(2 * (top - bottom) + 1);
    const handover::CoreGrid core =
        handover::core_grid(input, mesh, motion_box(input.motion, input.slider));
    history_values = (moves_water(input) ? 2.0 : 1.0) * // channels
                     static_cast<double>(handover::strain_grid(input, mesh, core).values());
  }

  /// Wall time of all positions. What lies under the slider is factorised once for each line of
  /// them, before the others. Without responses all is factorised once more for the strains.
  double seconds(int threads) const {
    const double rounds = std::ceil(static_cast<double>(positions) / threads),
                 further = further_factorisation(unknowns),
                 under_slider = first_factorisation(unknowns) - further;
    if (!keeps_responses()) {
      const double kept_lines = lines_across > 1 ? 2 * lines_across : 1;
      return passes * (kept_lines * under_slider + 2 * rounds * further);
    }
    const double response = seconds_per_response * unknowns * static_cast<double>(cells);
    return passes * (lines_across * under_slider + rounds * (further + response));
  }
  /// Wall time of the search for a round contact.
  double search_seconds() const {
    return searched_meshes * (first_factorisation(unknowns) + further_factorisation(unknowns));
  }
  /// Of steps along the path and of the strain of what is kept of them.
  double path_seconds(const mechanics::ExpectedSteps& steps) const {
    const auto components = static_cast<double>(cells);
    const double contact = driven ? seconds_per_driven_step : seconds_per_step;
    return passes * (static_cast<double>(steps.taken) * contact * components * components +
                     static_cast<double>(steps.kept) * seconds_per_strain * unknowns);
  }
  /// Strain of what is kept of the path [bytes].
  double history_memory(const mechanics::ExpectedSteps& steps) const {
    return sizeof(double) * history_values * static_cast<double>(steps.kept);
  }
  /// Responses to unit forces at the positions of the path, which are kept until its history is
  /// made wherever they are kept at all [bytes].
  double response_memory() const {
    // Without them, those to the load patterns of a path and of its companion's.
    constexpr double patterns = 16, paths = 2;
    const double of_position =
        keeps_responses() ? 3.0 * static_cast<double>(cells) * sizeof(std::int32_t)
                          : paths * patterns * linear_algebra::FixedPointColumns::bytes_per_entry;
    return passes * static_cast<double>(positions) * lattice * of_position;
  }
  bool keeps_responses() const {
    return mechanics::responses_fit(static_cast<int>(lattice), 0, static_cast<int>(3 * cells),
                                    positions);
  }
  /// Factors, strains that are recovered together and those under the test load at the positions,
  /// and the dense matrices of the contact at the positions that are solved at once [bytes].
  double working_memory(int at_once) const {
    constexpr double block_states = 48 + 48, test_states = 4; // with the patterns they combine
    constexpr double points = 8, strains = 6, matrices = 3;   // compliance, Newton's and its factor
    const double states = test_states * static_cast<double>(positions) + block_states;
    const double components = 3.0 * static_cast<double>(cells);
    return mechanics::factorisations_memory(static_cast<std::size_t>(unknowns), at_once) +
           sizeof(double) * (states * core_elements * points * strains +
                             at_once * matrices * components * components);
  }

  double unknowns = 0;
  std::size_t cells = 0, positions = 0;
  bool driven = false;
  double passes = 1, lines_across = 1;
  double core_elements = 0, lattice = 0; ///< unknowns of the core
  double history_values = 0;             ///< of one instant
};

/// Companions, by the name of `mechanics::companions`, that have a mesh of their own.
std::vector<const char*> companions_of(const Case& input) {
  namespace names = mechanics::companions;
  if (!input.numerics.error_estimate) {
    return {};
  }
  return mechanics::needs_thickness_companion(input) ? std::vector{names::mesh, names::thickness}
                                                     : std::vector{names::mesh};
}

} // namespace

MechanicsCost estimate_mechanics_cost(const Case& input, int threads,
                                      const std::optional<mesh::Footprint>& found) {
  const mesh::SkinMesh mesh = found ? mesh::SkinMesh(input, *found) : expected_mesh(input);
  const MeshCost own(input, mesh);
  const auto at_once = [threads](const MeshCost& cost) {
    return std::min(threads, static_cast<int>(cost.positions));
  };
  MechanicsCost cost;
  cost.unknowns = mesh.unknowns();
  cost.contact_cells = own.cells;
  cost.positions = own.positions;
  const mechanics::ExpectedSteps steps = mechanics::expected_steps(input);
  cost.steps = steps.taken;
  cost.histories = own.history_memory(steps);
  cost.seconds = own.seconds(at_once(own)) + own.path_seconds(steps);
  if (!input.slider.sharp()) {
    cost.seconds += own.search_seconds();
  }
  double kept = 0; // histories of the companions; what else they hold is gone when they end
  for (const char* name : companions_of(input)) {
    const Case of_companion = mechanics::companion_case(input, name);
    try {
      const MeshCost companion(of_companion, {of_companion, mesh.footprint()});
      // `path` steps along the same mesh, half as finely.
      const double paths = name == std::string_view(mechanics::companions::mesh) ? 1.5 : 1;
      cost.seconds += companion.seconds(at_once(companion)) + paths * companion.path_seconds(steps);
      cost.memory = std::max(cost.memory, kept + companion.response_memory() +
                                              companion.working_memory(at_once(companion)));
      kept += paths * companion.history_memory(steps);
    } catch (const UserError&) { // its mesh does not fit beside the slider: a run goes without
    }
  }
  cost.histories += kept;
  cost.memory =
      std::max({cost.memory, kept + own.response_memory() + own.working_memory(at_once(own)),
                own.response_memory() + cost.histories});
  return cost;
}

} // namespace ionskin::planning
