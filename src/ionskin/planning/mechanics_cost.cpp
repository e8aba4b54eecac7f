// SPDX-License-Identifier: Apache-2.0
#include "ionskin/planning/mechanics_cost.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/coupling.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/finite_layers/fields/states_at_once.hpp"
#include "ionskin/handover/sliders/fixed_grid.hpp"
#include "ionskin/handover/strain_grid.hpp"
#include "ionskin/mechanics/coarser_solutions.hpp"
#include "ionskin/mechanics/engine/drive_room.hpp"
#include "ionskin/mechanics/path/contact_box.hpp"
#include "ionskin/mechanics/path/expected_steps.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/mechanics/path/first_touch.hpp"
#include "ionskin/mechanics/skin/compliance_form.hpp"
#include "ionskin/mechanics/skin/skin_reach.hpp"
#include "ionskin/mechanics/surface/contact_cells.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace ionskin::planning {
namespace {

// Processor time [s], measured with AVX2 on cases/paper.toml, cases/finger.toml and
// cases/waypoints.toml, with a soft finger, a height map, and sweeps of friction, which separate
// the cost of the skin from that of the path.
constexpr double seconds_per_skin = 0.38, seconds_per_pair_of_cells = 5.7e-6;
/// Additional time of a skin per wave along its sides and along its ends [s], measured near a side,
/// near an end and on skins of 100 x 100 mm2.
constexpr double seconds_per_side_wave = 9e-3, seconds_per_end_wave = 1.6e-2;
/// Time of a load step of the contact over the square of the number of cells [s], without and with
/// a drive.
constexpr double seconds_per_step = 2.2e-7, seconds_per_driven_step = 8e-7;
/// Contacts of many cells, solved with products of the compliance in place of its matrix: products
/// in a step; time of a product and of one cell in it [s]; time to build the compliance over the
/// distance, per cell [s]. Measured on a height map.
constexpr double products_per_step = 150, seconds_per_product = 5e-3,
                 seconds_per_product_and_cell = 3e-6, seconds_per_distance = 1e-5;
/// Additional time of a load step at a new position across the skin, per `SkinSize::plane` [s]: the
/// compliance of rows of cells is summed over all modes again.
constexpr double seconds_per_place_across = 1e-4;
/// Time of one multiplication in a load step near an end of the skin [s], where the waves along the
/// end are solved for the cells again at each position. Measured 0.1 to 0.4 mm from an end.
constexpr double seconds_per_end_product = 1e-10;
/// Time to recover the strain of a stored instant of the path, per point of the core [s].
constexpr double seconds_per_strain = 1.3e-6;
/// Memory per row of contact cells and row of elements [bytes], measured on cases/paper.toml and
/// cases/finger.toml.
constexpr double row_bytes = 4e5;
/// Number of contact grids on which the footprint of a round slider is searched.
constexpr double searched_grids = 4;

/// Mesh for the footprint that a coarse solution is expected to find. Throws UserError when a round
/// slider never touches the skin, for which the mesh would have elements without size.
mesh::SkinMesh expected_mesh(const Case& input) {
  if (!input.slider.sharp()) {
    mechanics::require_touch(input);
  }
  return {input, mesh::expected_footprint(input)};
}

/// Numbers of waves of a skin. The motions of its free faces are matrices between nodes through the
/// thickness; a skin of thick electrodes counts more, as it has more nodes.
struct SkinSize {
  SkinSize(const Case& input, const mesh::SkinMesh& mesh, const MotionBox& places) {
    constexpr double usual_nodes = 31; // of a thick core between thin electrodes
    const mechanics::SkinWaves waves = mechanics::skin_waves(input.skin, mesh.footprint(), places);
    const double nodes = mechanics::nodes_through_thickness(input.skin) / usual_nodes;
    const double weight = nodes * nodes * (mesh.half_model() ? 1 : 2); // odd waves, too
    plane = (input.skin.length / waves.reach) * (input.skin.width / waves.reach);
    sides = input.skin.sides == SideCondition::free ? weight * waves.along_sides : 0;
    ends = weight * waves.along_ends;
  }

  /// Memory of the modes and of their strain in the core [bytes]. Measured on skins of 15 x 2.5 to
  /// 100 x 100 mm2, 0.2 mm thick, and beside a side and an end.
  double memory() const { return 4e4 * plane + 1.4e6 * sides + 2.5e6 * ends; }

  /// Length times width of the skin, each over the reach of its short waves [1].
  double plane = 0;
  double sides = 0, ends = 0; ///< waves along the sides and along the ends, times their nodes [1]
};

/// Box in which the slider's centre is expected [m].
MotionBox places_of(const Case& input, const mesh::SkinMesh& mesh) {
  const MotionBox touching =
      mechanics::contact_box(input).value_or(motion_box(input.motion, input.slider));
  return mechanics::expected_places(input, touching, mesh.footprint());
}

/// Cost of the mechanics on one grid of contact cells.
struct GridCost {
  GridCost(const Case& input, const mesh::SkinMesh& mesh)
      : GridCost(input, mesh, places_of(input, mesh)) {}
  /// @param places box in which the slider's centre is expected [m]
  GridCost(const Case& input, const mesh::SkinMesh& mesh, const MotionBox& places)
      : size(input, mesh, places),
        cells(static_cast<double>(mechanics::contact_cells(mesh).count())),
        driven(input.motion.drive.given()),
        products(mechanics::takes_products(input, mechanics::contact_cells(mesh))) {
    at_ends = products
                  ? 0
                  : seconds_per_end_product *
                        mechanics::expected_steps(
                            input, mechanics::end_products(input.skin, mesh.footprint(), places,
                                                           3 * cells, mesh.half_model()))
                            .of_places;
    const auto [nx, ny, nz] = mesh.elements();
    const auto [bottom, top] = mesh.core_z();
    points = 8.0 * static_cast<double>(nx * ny * (top - bottom));
    const handover::CoreGrid core =
        handover::core_grid(input, mesh, motion_box(input.motion, input.slider));
    const MotionBox box = motion_box(input.motion, input.slider);
    if (!products && (mesh.half_model() || box.low[1] == box.high[1])) {
      const auto [first, end] = mesh.footprint_y();
      rows = row_bytes * static_cast<double>((end - first) * ny);
    }
    history_values = (moves_water(input) ? 2.0 : 1.0) * // channels
                     static_cast<double>(handover::strain_grid(input, mesh, core).values());
  }

  double skin_seconds() const {
    const double of_cells =
        products ? seconds_per_distance * cells : seconds_per_pair_of_cells * cells * cells;
    return seconds_per_skin + seconds_per_side_wave * size.sides +
           seconds_per_end_wave * size.ends + of_cells;
  }
  /// Time of the load steps along the path [s].
  double path_seconds(const mechanics::ExpectedSteps& steps) const {
    const double contact = driven ? seconds_per_driven_step : seconds_per_step;
    const double step =
        products ? products_per_step * (seconds_per_product + seconds_per_product_and_cell * cells)
                 : contact * cells * cells;
    return static_cast<double>(steps.taken) * step +
           static_cast<double>(steps.across) * seconds_per_place_across * size.plane + at_ends;
  }
  /// Time to recover the strain of the stored steps, by one thread; threads share it [s].
  double strain_seconds(const mechanics::ExpectedSteps& steps) const {
    return static_cast<double>(steps.kept) * seconds_per_strain * points;
  }
  /// Memory of the strain history of the stored steps [bytes].
  double history_memory(const mechanics::ExpectedSteps& steps) const {
    return sizeof(double) * history_values * static_cast<double>(steps.kept);
  }
  /// Memory of the contact solver [bytes]: dense matrices, or, with products in place of the
  /// matrix, transforms of the compliance over the distance and directions of the iterative solver.
  double contact_memory(int threads) const {
    constexpr double matrices = 6, vectors_of_products = 400;
    if (products) {
      return sizeof(double) * threads * vectors_of_products * cells;
    }
    return sizeof(double) * threads * matrices * 9 * cells * cells;
  }
  /// Memory of the strains that are recovered at the same time, after the contact is solved
  /// [bytes].
  double strain_memory(int threads) const {
    constexpr double strains = 6, states_per_thread = finite_layers::states_at_once;
    return sizeof(double) * states_per_thread * threads * points * strains;
  }

  SkinSize size;
  double cells = 0, points = 0; ///< number of contact cells, and of strain points of the core
  /// Memory of the matrices from forces on rows of cells to strains, stored where the slider stays
  /// at one position across the skin [bytes].
  double rows = 0;
  double at_ends = 0; ///< time for the waves along the ends over the whole path [s]
  bool driven = false;
  bool products = false;     ///< true if products of the compliance stand in place of its matrix
  double history_values = 0; ///< number of values of the strain history at one instant
};

/// Names (`mechanics::coarser_solutions`) of the coarser solutions that have contact cells of their
/// own; empty without an error estimate.
std::vector<const char*> coarser_names(const Case& input) {
  namespace names = mechanics::coarser_solutions;
  if (!input.numerics.error_estimate) {
    return {};
  }
  return mechanics::needs_coarser_thickness(input) ? std::vector{names::mesh, names::thickness}
                                                   : std::vector{names::mesh};
}

} // namespace

namespace {

/// Number of passes over the paths of several sliders until their forces agree.
constexpr double passes = 3;

/// Cost of several sliders. They are solved one after another and in several passes; their coarser
/// solutions run beside them, each on one thread. The strain is stored on a grid fixed to the skin.
MechanicsCost estimate_sliders_cost(const Case& input, int threads) {
  const std::vector<Case> sliders = cases_of_sliders(input);
  std::vector<mesh::SkinMesh> meshes;
  std::vector<const mesh::SkinMesh*> all;
  const bool half =
      std::ranges::all_of(sliders, [](const Case& one) { return expected_mesh(one).half_model(); });
  for (const Case& one : sliders) {
    meshes.emplace_back(one, mesh::expected_footprint(one),
                        half ? mesh::MeshedPart::half_if_symmetric : mesh::MeshedPart::whole);
  }
  for (const mesh::SkinMesh& mesh : meshes) {
    all.push_back(&mesh);
  }
  MechanicsCost cost;
  double work = 0, ways = 0, kept = 0;
  for (std::size_t i = 0; i < sliders.size(); ++i) {
    const GridCost own(sliders[i], meshes[i]);
    const mechanics::ExpectedSteps steps = mechanics::expected_steps(sliders[i]);
    work += passes * (own.skin_seconds() + own.path_seconds(steps)) + own.strain_seconds(steps);
    cost.contact_cells += static_cast<std::size_t>(own.cells);
    cost.steps += steps.taken;
    cost.memory +=
        own.size.memory() + own.rows + std::max(own.contact_memory(1), own.strain_memory(1));
    kept += static_cast<double>(steps.kept);
    for (const MotionLeg& leg : motion_legs(sliders[i].motion, sliders[i].slider)) {
      ways += leg.touches() ? leg.length() : 0;
    }
  }
  const handover::CoreGrid grid = handover::fixed_core_grid(sliders, all);
  // With water, the history has twice as many levels and channels.
  const double values = (moves_water(input) ? 4.0 : 1.0) *
                        static_cast<double>((grid.x_edges.size() - 1) * (grid.y_edges.size() - 1) *
                                            grid.z_lines.size());
  const double samples = kept + ways / handover::fixed_cell_width(input);
  // Coarser solutions have a quarter of the cells, and half the samples.
  const auto coarser = static_cast<double>(coarser_names(input).size() + 1);
  const double all_work = input.numerics.error_estimate ? work * (1 + 0.5 * coarser) : work;
  cost.histories =
      sizeof(double) * values * samples * (input.numerics.error_estimate ? 1 + coarser / 8 : 1);
  cost.seconds = std::max(work, all_work / threads);
  cost.further_seconds = cost.seconds;
  cost.memory += cost.histories;
  return cost;
}

} // namespace

MechanicsCost estimate_mechanics_cost(const Case& input, int threads,
                                      const std::optional<mesh::Footprint>& found) {
  if (!input.further_sliders.empty()) {
    return estimate_sliders_cost(input, threads);
  }
  const mesh::SkinMesh mesh = found ? mesh::SkinMesh(input, *found) : expected_mesh(input);
  const GridCost own(input, mesh);
  const mechanics::ExpectedSteps steps = mechanics::expected_steps(input);
  MechanicsCost cost;
  cost.contact_cells = static_cast<std::size_t>(own.cells);
  cost.steps = steps.taken;
  cost.histories = own.history_memory(steps);
  double sought = 0, path = own.path_seconds(steps), strain = own.strain_seconds(steps);
  double beside = 0,
         path_beside = 0; // coarser solutions, on a thread of their own
  for (const char* name : coarser_names(input)) {
    const Case coarser_input = mechanics::coarser_case(input, name);
    try {
      const GridCost coarser(coarser_input, {coarser_input, mesh.footprint()});
      // The coarser solution `path` uses the same cells, with half as many steps.
      const double paths = name == std::string_view(mechanics::coarser_solutions::mesh) ? 1.5 : 1;
      beside += coarser.skin_seconds();
      path_beside += paths * coarser.path_seconds(steps);
      strain += paths * coarser.strain_seconds(steps);
      cost.histories += paths * coarser.history_memory(steps);
      if (!input.slider.sharp()) {
        sought += searched_grids * coarser.skin_seconds();
      }
    } catch (const UserError&) { // its cells do not fit beside the slider: a run does without it
    }
  }
  const double alone = own.skin_seconds() + path;
  beside += path_beside;
  cost.seconds =
      sought + (threads > 1 ? std::max(alone, beside) : alone + beside) + strain / threads;
  cost.further_seconds = (path + path_beside + strain) / threads;
  cost.memory = own.size.memory() + own.rows +
                std::max(own.contact_memory(threads), own.strain_memory(threads) + cost.histories);
  return cost;
}

} // namespace ionskin::planning
