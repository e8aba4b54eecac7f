// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/factorised_skin.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/free_memory.hpp"
#include "ionskin/linear_algebra/dense_kernels.hpp"
#include "ionskin/mechanics/elasticity/elastic_system.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace ionskin::mechanics {
namespace {

using linear_algebra::DenseMatrix;

/// Threads of the kernels of what a factor that is alone in memory has only one of: the part under
/// the slider and the interface. BLAS splits its sums by the number of threads, so it is the same
/// whatever number a run is given.
constexpr int lone_factor_threads = 2;

DenseMatrix rows_of(const DenseMatrix& matrix, int first, int count) {
  DenseMatrix result(count, matrix.columns);
  for (int j = 0; j < matrix.columns; ++j) {
    std::copy_n(matrix.column(j) + first, count, result.column(j));
  }
  return result;
}

/// Columns of unit forces in one direction, transposed.
DenseMatrix states_of(const DenseMatrix& unit, int direction, int first, int count) {
  DenseMatrix result(count, unit.rows);
  for (int j = 0; j < count; ++j) {
    const double* column = unit.column(3 * (first + j) + direction);
    for (int i = 0; i < unit.rows; ++i) {
      result(j, i) = column[i];
    }
  }
  return result;
}

DenseMatrix transposed(const DenseMatrix& matrix) {
  DenseMatrix result(matrix.columns, matrix.rows);
  for (int j = 0; j < matrix.columns; ++j) {
    for (int i = 0; i < matrix.rows; ++i) {
      result(j, i) = matrix(i, j);
    }
  }
  return result;
}

} // namespace

PartFactor::PartFactor(const SkinPart& part, const mesh::MeshLines& lines,
                       const std::vector<ElasticLaw>& law_of_row, int threads) {
  const ElasticSystem system = assemble(part.space, lines, law_of_row);
  cholesky_ =
      std::make_unique<const linear_algebra::Cholesky>(part.symbolic, system.stiffness, threads);
  for (std::size_t c = 0; c < 3; ++c) {
    for (const int unknown : part.symbolic.order()) {
      base_reaction_[c].push_back(system.base_reaction[c][unknown]);
    }
  }
}

void PartFactor::add_reaction(const PlacedPart& placed, std::size_t axis,
                              std::array<std::vector<double>, 3>& whole) const {
  for (std::size_t c = 0; c < 3; ++c) {
    const double turned = placed.mirrored && c == axis ? -1 : 1;
    for (std::size_t k = 0; k < placed.whole_unknown.size(); ++k) {
      whole[c][placed.whole_unknown[k]] += turned * placed.sign[k] * base_reaction_[c][k];
    }
  }
}

InnerFactor::InnerFactor(const SkinParts& parts, const ContactCells& cells,
                         const mesh::MeshLines& lines, const std::vector<ElasticLaw>& law_of_row,
                         int threads)
    : factor(*parts.inner.part, lines, law_of_row, threads) {
  const linear_algebra::KernelThreads kernel_threads(threads);
  condense(factor.cholesky().trailing_block(), parts, cells.unit_load);
}

// The trailing block is that of the unknowns under the slider, c, before the interface, i.
void InnerFactor::condense(const DenseMatrix& trailing, const SkinParts& parts,
                           const DenseMatrix& unit_load) {
  const int on_interface = parts.interface, under_slider = trailing.rows - on_interface;
  DenseMatrix load(trailing.rows, unit_load.columns);
  for (int j = 0; j < load.columns; ++j) {
    for (int i = 0; i < load.rows; ++i) {
      load(i, j) = parts.load_row[i] < 0 ? 0.0 : unit_load(parts.load_row[i], j);
    }
  }
  linear_algebra::solve_left(false, under_slider, load.columns, trailing.values.data(),
                             trailing.rows, load.values.data(), load.rows);
  linear_algebra::product(false, on_interface, load.columns, under_slider, -1.0,
                          trailing.values.data() + under_slider, trailing.rows, load.values.data(),
                          load.rows, 1.0, load.values.data() + under_slider, load.rows);
  contact = rows_of(load, 0, under_slider);
  interface = rows_of(load, under_slider, on_interface);
  compliance = linear_algebra::gram(contact);
  DenseMatrix last(on_interface, on_interface);
  for (int j = 0; j < on_interface; ++j) {
    std::copy_n(trailing.column(under_slider + j) + under_slider, on_interface, last.column(j));
  }
  schur = linear_algebra::gram_of_rows(last);
}

void SkinDisplacement::copy(int first, int count, DenseMatrix& whole) const {
  for (int i = 0; i < whole.rows; ++i) {
    const PartUnknown& unknown = parts_.unknown[static_cast<std::size_t>(i)];
    const DenseMatrix& part =
        unknown.part == 0 ? inner_ : outer_[static_cast<std::size_t>(unknown.part - 1)];
    const double* from = part.column(unknown.place) + first;
    for (int j = 0; j < count; ++j) {
      whole(i, j) = unknown.sign * from[j];
    }
  }
}

FactorisedSkin::Place::Place(std::counting_semaphore<>& places) : places_(places) {
  places_.acquire();
}

FactorisedSkin::Place::~Place() {
  base::return_free_memory();
  places_.release();
}

FactorisedSkin::FactorisedSkin(const ElasticSkin& skin, const mesh::MeshLines& lines, int threads)
    : place_(skin.analysis().free_factors),
      threads_(skin.analysis().factors_at_once == 1 ? threads : 1),
      kernel_threads_(skin.analysis().factors_at_once == 1 ? lone_factor_threads : 1),
      parts_(skin.analysis().parts) {
  const mesh::MeshLines inner_lines = parts_.inner_lines(skin.cells, lines);
  const auto inner = skin.analysis().inner(inner_lines);
  const auto make = [&] {
    return std::make_unique<const InnerFactor>(parts_, skin.cells, inner_lines, skin.law_of_row,
                                               kernel_threads_);
  };
  if (inner->begin()) {
    inner_ = inner->get(make);
    factorise_outer(skin, lines);
  } else { // another thread makes it meanwhile
    factorise_outer(skin, lines);
    inner_ = inner->get(make);
  }
  join();
  gather_reactions(skin.space.unknowns());
}

void FactorisedSkin::factorise_outer(const ElasticSkin& skin, const mesh::MeshLines& lines) {
  std::vector<std::optional<PartFactor>> made(parts_.outer.size());
  parallel::run_tasks(made.size(), threads_, [&](std::size_t p) {
    const PlacedPart& placed = parts_.outer[p];
    made[p].emplace(*placed.part, parts_.outer_lines(placed, lines), skin.law_of_row);
  });
  for (auto& factor : made) {
    outer_.push_back(std::move(*factor));
  }
}

void FactorisedSkin::join() {
  const linear_algebra::KernelThreads kernel_threads(kernel_threads_);
  DenseMatrix stiffness = inner_->schur;
  for (std::size_t p = 0; p < outer_.size(); ++p) {
    const PlacedPart& placed = parts_.outer[p];
    const DenseMatrix own = linear_algebra::gram_of_rows(outer_[p].cholesky().trailing_block());
    const double* sign = placed.sign.data() + placed.sign.size() - own.rows;
    const int first = placed.first_interface;
    for (int j = 0; j < own.columns; ++j) {
      for (int i = 0; i < own.rows; ++i) {
        stiffness(first + i, first + j) += sign[i] * sign[j] * own(i, j);
      }
    }
  }
  if (!linear_algebra::factorise(stiffness.rows, stiffness.values.data(), stiffness.rows)) {
    throw SolverError("the stiffness matrix is not positive definite between the parts of the skin",
                      "check the elastic constants and layer thicknesses for extreme ratios");
  }
  interface_ = inner_->interface;
  const auto solve = [&](bool transpose) {
    linear_algebra::solve_left(transpose, interface_.rows, interface_.columns,
                               stiffness.values.data(), stiffness.rows, interface_.values.data(),
                               interface_.rows);
  };
  solve(false);
  compliance_ = linear_algebra::gram(interface_);
  for (std::size_t at = 0; at < compliance_.values.size(); ++at) {
    compliance_.values[at] += inner_->compliance.values[at];
  }
  solve(true);
}

void FactorisedSkin::unit_displacement(int direction, int first, int count,
                                       SkinDisplacement& result) const {
  complete(states_of(inner_->contact, direction, first, count),
           states_of(interface_, direction, first, count), result);
}

void FactorisedSkin::displacement(const DenseMatrix& forces, SkinDisplacement& result) const {
  const auto states = [&](const DenseMatrix& unit) {
    return transposed(linear_algebra::multiply(unit, forces));
  };
  complete(states(inner_->contact), states(interface_), result);
}

void FactorisedSkin::complete(const DenseMatrix& contact, const DenseMatrix& interface,
                              SkinDisplacement& result) const {
  const int states = interface.rows;
  const auto& inner = parts_.inner;
  result.inner_.reshape(states, inner.part->space.unknowns());
  const int begin_interface = result.inner_.columns - interface.columns;
  std::ranges::copy(contact.values, result.inner_.column(begin_interface - contact.columns));
  std::ranges::copy(interface.values, result.inner_.column(begin_interface));
  inner_->factor.cholesky().complete(interface.columns, contact.columns, result.inner_);
  for (std::size_t p = 0; p < outer_.size(); ++p) {
    const PlacedPart& placed = parts_.outer[p];
    const int own = placed.part->interface;
    DenseMatrix& outer = result.outer_[p];
    outer.reshape(states, placed.part->space.unknowns());
    for (int k = 0; k < own; ++k) {
      const int last = outer.columns - own + k;
      const double* from = interface.column(placed.first_interface + k);
      std::transform(from, from + states, outer.column(last),
                     [&](double value) { return placed.sign[last] * value; });
    }
    outer_[p].cholesky().complete(own, 0, outer);
  }
}

void FactorisedSkin::gather_reactions(int unknowns) {
  std::array<std::vector<double>, 3> whole;
  whole.fill(std::vector<double>(static_cast<std::size_t>(unknowns)));
  inner_->factor.add_reaction(parts_.inner, parts_.cut.axis, whole);
  for (std::size_t p = 0; p < outer_.size(); ++p) {
    outer_[p].add_reaction(parts_.outer[p], parts_.cut.axis, whole);
  }
  for (std::size_t i = 0; i < whole[0].size(); ++i) {
    if (whole[0][i] != 0 || whole[1][i] != 0 || whole[2][i] != 0) {
      base_reaction_.emplace_back(i, std::array{whole[0][i], whole[1][i], whole[2][i]});
    }
  }
}

std::array<double, 3> FactorisedSkin::base_reaction(const double* displacement) const {
  std::array<double, 3> result{};
  for (const auto& [unknown, reaction] : base_reaction_) {
    for (std::size_t r = 0; r < 3; ++r) {
      result[r] += reaction[r] * displacement[unknown];
    }
  }
  return result;
}

} // namespace ionskin::mechanics
