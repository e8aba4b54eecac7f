// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/contact_state.hpp"

#include "ionskin/mechanics/surface/adhesion_energy.hpp"
#include "ionskin/mechanics/surface/contact_diagnostics.hpp"
#include "ionskin/mechanics/surface/covered_area.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {
namespace {

void store_tractions(const ContactCells& cells, const CellVector& force, ContactState& state) {
  for (std::size_t cell = 0; cell < cells.count(); ++cell) {
    state.normal_traction.push_back(force[3 * cell] / cells.area[cell]);
    state.tangential_traction_x.push_back(force[3 * cell + 1] / cells.area[cell]);
    state.tangential_traction_y.push_back(force[3 * cell + 2] / cells.area[cell]);
  }
}

/// Stores total forces and moments of the full skin. A uniform traction acts at the middle of its
/// cell.
void store_sums(const ContactCells& cells, const CellVector& force, bool half_model,
                ContactState& state) {
  std::array<double, 3> sum{}, moment{};
  for (std::size_t cell = 0; cell < cells.count(); ++cell) {
    const std::array<double, 2> arm = cells.middle(cell);
    const double *of_cell = force.data() + 3 * cell, normal = of_cell[0];
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += of_cell[c];
    }
    moment[0] -= arm[1] * normal;
    moment[1] += arm[0] * normal;
    moment[2] += arm[0] * of_cell[2] - arm[1] * of_cell[1];
  }
  const double factor = half_model ? 2 : 1;
  state.normal_force = factor * sum[0];
  // The forces along y of the two halves of a half model cancel, and so do the moments about x, z.
  state.tangential_force = {factor * sum[1], half_model ? 0.0 : sum[2]};
  state.moment = {half_model ? 0.0 : moment[0], factor * moment[1], half_model ? 0.0 : moment[2]};
}

} // namespace

double largest_normal_force(const CellVector& force) {
  double largest = 0;
  for (std::size_t at = 0; at < force.size(); at += 3) {
    largest = std::max(largest, std::abs(force[at]));
  }
  return largest;
}

void describe(const SkinModel& model, const SurfaceState& state, const ContactProblem& problem,
              double reference_force, double reference_indentation, ContactState& destination) {
  store_tractions(model.cells, state.force, destination);
  destination.surface = state.surface;
  store_sums(model.cells, state.force, model.mesh.half_model(), destination);
  destination.slip = state.slip;
  destination.indentation = state.indentation;
  const double parts = model.mesh.half_model() ? 2 : 1;
  destination.contact_area = parts * contact_area(model.cells.grid(), state.force);
  destination.stick_reserve = stick_reserve(problem, state.force);
  destination.stick_area = parts * covered_area(model.cells.grid(), destination.stick_reserve);
  destination.contact_border =
      parts * border_area(model.cells.grid(), normal_pressure(model.cells.grid(), state.force));
  destination.stick_border = parts * border_area(model.cells.grid(), destination.stick_reserve);
  destination.complementarity_residual =
      contact_violations(problem, state, reference_force, reference_indentation).largest();
  destination.binding_energy = parts * binding_energy(problem, state);
  destination.friction_energy = parts * friction_energy(problem, state).stored;
  destination.stick_fraction = stick_fraction(problem, state.force);
  destination.iterations = state.iterations;
}

} // namespace ionskin::mechanics
