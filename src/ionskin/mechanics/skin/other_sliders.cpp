// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/skin/other_sliders.hpp"

#include "ionskin/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ionskin::mechanics {
namespace {

/// One component of the values on the cells, as a matrix [column, row].
/// @param values [3 cells]
Eigen::MatrixXd component_of(const CellVector& values, std::size_t component,
                             const finite_layers::ContactGrid& cells) {
  Eigen::MatrixXd result(cells.columns(), cells.rows());
  for (Eigen::Index cell = 0; cell < cells.count(); ++cell) {
    result.data()[cell] = values[3 * static_cast<std::size_t>(cell) + component];
  }
  return result;
}

std::array<double, 2> half_size(const finite_layers::ContactGrid& cells) {
  const double across = cells.y.back() - cells.y.front();
  return {0.5 * (cells.x.back() - cells.x.front()), cells.half ? across : 0.5 * across};
}

} // namespace

CellVector moved_by_others(const SkinModel& model, const std::vector<ForcePath>& others,
                           double time, const std::array<double, 2>& place) {
  const finite_layers::ContactGrid& own = model.layers.grid();
  CellVector result(3 * static_cast<std::size_t>(own.count()), 0.0);
  for (const ForcePath& other : others) {
    const ForcePath::Instant instant = other.at(time);
    if (std::ranges::all_of(instant.force, [](double force) { return force == 0; })) {
      continue;
    }
    const finite_layers::ContactGrid cells{other.lines_x, other.lines_y, other.half};
    const double apart = distance(place, half_size(own), instant.centre, half_size(cells));
    if (apart < model.layers.reach()) {
      throw SolverError(fmt::format("two sliders come within {:.3g} mm of each other at {:.3g} s",
                                    1e3 * apart, time),
                        fmt::format("keep them {:.3g} mm apart: nearer, the local deformations "
                                    "under both overlap, which is not solved",
                                    1e3 * model.layers.reach()));
    }
    finite_layers::CellFields forces;
    for (std::size_t c = 0; c < 3; ++c) {
      forces[c] = component_of(instant.force, c, cells);
    }
    const auto moved = model.layers.moved_by(cells, instant.centre, forces, place);
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] += moved[i % 3].data()[i / 3];
    }
  }
  return result;
}

} // namespace ionskin::mechanics
