// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/condensed_position.hpp"

#include "ionskin/mechanics/core_strain.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace ionskin::mechanics {
namespace {

/// States recovered in one blocked solve; bounds the memory.
constexpr std::size_t block_size = 32;

} // namespace

CondensedPosition::CondensedPosition(const SkinModel& model, const std::array<double, 2>& centre)
    : model_(model), lines_(model.mesh.lines(centre)) {
  ElasticSystem system = assemble(model.space, lines_, model.law_of_row);
  factor_ = std::make_unique<linear_algebra::Cholesky>(model.symbolic, system.stiffness);
  base_reaction_ = std::move(system.base_reaction);
  forward_ = factor_->trailing_forward(model.cells.unit_load);
  compliance_ = linear_algebra::gram(forward_);
}

double CondensedPosition::equilibrium_residual(const double* displacement,
                                               const CellVector& force) const {
  // Force components are normal (downwards), x, y; the base pushes back along x, y, z.
  constexpr std::array<int, 3> direction{2, 0, 1};
  double worst = 0, largest = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    double load = 0;
    for (std::size_t at = c; at < force.size(); at += 3) {
      load += c == 0 ? -force[at] : force[at];
    }
    largest = std::max(largest, std::abs(load));
    if (model_.space.held_by_base_alone(direction[c])) {
      const std::vector<double>& row = base_reaction_[direction[c]];
      const double reaction = std::inner_product(row.begin(), row.end(), displacement, 0.0);
      worst = std::max(worst, std::abs(load - reaction));
    }
  }
  return largest > 0 ? worst / largest : 0.0;
}

std::vector<CondensedPosition::Response>
CondensedPosition::respond(const std::vector<CellVector>& forces) const {
  std::vector<Response> responses;
  for (std::size_t first = 0; first < forces.size(); first += block_size) {
    const std::size_t last = std::min(forces.size(), first + block_size);
    const int count = static_cast<int>(last - first);
    linear_algebra::DenseMatrix block(forward_.columns, count);
    for (int j = 0; j < count; ++j) {
      std::copy(forces[first + j].begin(), forces[first + j].end(), block.column(j));
    }
    const linear_algebra::DenseMatrix displacement =
        factor_->backward_from_trailing(linear_algebra::multiply(forward_, block));
    std::vector<CoreStrain> strains =
        core_strain(model_.space, lines_, model_.mesh.core_z(), displacement);
    for (int j = 0; j < count; ++j) {
      responses.push_back(
          {std::move(strains[j]), equilibrium_residual(displacement.column(j), forces[first + j])});
    }
  }
  return responses;
}

} // namespace ionskin::mechanics
