// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/path/position_states.hpp"

#include "ionskin/mechanics/elasticity/core_strain.hpp"
#include "ionskin/mechanics/surface/adhesive_contact.hpp"
#include "ionskin/mechanics/surface/contact_diagnostics.hpp"
#include "ionskin/mechanics/surface/covered_area.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace ionskin::mechanics {
namespace {

std::size_t reflected_cell(const ContactCells& cells, std::size_t cell,
                           const std::array<bool, 2>& reflect) {
  const std::size_t nx = cells.columns(), ny = cells.rows(), i = cell % nx, j = cell / nx;
  return (reflect[0] ? nx - 1 - i : i) + nx * (reflect[1] ? ny - 1 - j : j);
}

void store_tractions(const ContactCells& cells, const CellVector& force, ContactState& state) {
  for (std::size_t cell = 0; cell < cells.count(); ++cell) {
    state.normal_traction.push_back(force[3 * cell] / cells.area[cell]);
    state.tangential_traction_x.push_back(force[3 * cell + 1] / cells.area[cell]);
    state.tangential_traction_y.push_back(force[3 * cell + 2] / cells.area[cell]);
  }
}

void store_sums(const CellVector& force, bool half_model, ContactState& state) {
  std::array<double, 3> sum{};
  for (std::size_t at = 0; at < force.size(); ++at) {
    sum[at % 3] += force[at];
  }
  const double factor = half_model ? 2 : 1;
  state.normal_force = factor * sum[0];
  // In a half model the forces along y of the two halves cancel.
  state.tangential_force = {factor * sum[1], half_model ? 0.0 : sum[2]};
}

} // namespace

double largest_normal_force(const CellVector& force) {
  double largest = 0;
  for (std::size_t at = 0; at < force.size(); at += 3) {
    largest = std::max(largest, std::abs(force[at]));
  }
  return largest;
}

CellVector reflected(const ContactCells& cells, const CellVector& vector,
                     const std::array<bool, 2>& reflect) {
  CellVector result(vector.size());
  for (std::size_t cell = 0; cell < cells.count(); ++cell) {
    const std::size_t from = 3 * reflected_cell(cells, cell, reflect), to = 3 * cell;
    result[to] = vector[from];
    result[to + 1] = reflect[0] ? -vector[from + 1] : vector[from + 1];
    result[to + 2] = reflect[1] ? -vector[from + 2] : vector[from + 2];
  }
  return result;
}

void describe(const SkinModel& model, const SurfaceState& state, const ContactProblem& problem,
              const CanonicalPosition& position, double reference_force,
              double reference_indentation, ContactState& destination) {
  const CellVector force = reflected(model.cells, state.force, position.reflect);
  store_tractions(model.cells, force, destination);
  destination.surface = reflected(model.cells, state.surface, position.reflect);
  store_sums(force, model.mesh.half_model(), destination);
  for (std::size_t cell = 0; cell < model.cells.count(); ++cell) {
    destination.slip.push_back(state.slip[reflected_cell(model.cells, cell, position.reflect)]);
  }
  destination.indentation = state.indentation;
  const double parts = model.mesh.half_model() ? 2 : 1;
  destination.contact_area = parts * contact_area(model.cells.grid(), state.force);
  const std::vector<double> reserve = stick_reserve(problem, state.force);
  destination.stick_area = parts * covered_area(model.cells.grid(), reserve);
  for (std::size_t cell = 0; cell < model.cells.count(); ++cell) {
    destination.stick_reserve.push_back(
        reserve[reflected_cell(model.cells, cell, position.reflect)]);
  }
  destination.contact_border =
      parts * border_area(model.cells.grid(), normal_pressure(model.cells.grid(), state.force));
  destination.stick_border = parts * border_area(model.cells.grid(), reserve);
  destination.complementarity_residual =
      contact_violations(problem, state, reference_force, reference_indentation).largest();
  destination.binding_energy = parts * binding_energy(problem, state);
  destination.stick_fraction = stick_fraction(problem, state.force);
  destination.iterations = state.iterations;
}

void PositionStates::add(ContactState& destination, SurfaceState state,
                         const ContactProblem& problem, const CanonicalPosition& position,
                         double reference_force, double reference_indentation) {
  describe(*model_, state, problem, position, reference_force, reference_indentation, destination);
  pending_.push_back({&destination, std::move(state.force), position.reflect});
}

void PositionStates::append(PositionStates other) {
  std::ranges::move(other.pending_, std::back_inserter(pending_));
}

void PositionStates::complete(const CondensedPosition& position, std::size_t begin,
                              std::size_t end) const {
  std::vector<CellVector> forces;
  for (std::size_t i = begin; i < end; ++i) {
    forces.push_back(pending_[i].force);
  }
  std::vector<CondensedPosition::Response> responses = position.respond(forces);
  for (std::size_t i = begin; i < end; ++i) {
    ContactState& state = *pending_[i].destination;
    CondensedPosition::Response response = std::move(responses[i - begin]);
    const bool reflect = pending_[i].reflect[0] || pending_[i].reflect[1];
    state.strain = reflect ? mirrored(std::move(response.strain), pending_[i].reflect)
                           : std::move(response.strain);
    state.electrode_stress = std::move(response.electrode_stress);
    state.equilibrium_residual = response.equilibrium_residual;
  }
}

} // namespace ionskin::mechanics
