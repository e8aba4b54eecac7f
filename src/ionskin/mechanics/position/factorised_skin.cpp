// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/factorised_skin.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/free_memory.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/linear_algebra/dense_kernels.hpp"
#include "ionskin/mechanics/elasticity/elastic_system.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace ionskin::mechanics {
namespace {

using linear_algebra::DenseMatrix;

/// Threads of the kernels at the interface of a factor that is alone in memory, of which there is
/// only one. BLAS splits its sums by the number of threads, so it is the same whatever number a run
/// is given.
constexpr int lone_factor_threads = 2;

/// Unit forces whose displacement of the interface is solved together where kernels have a thread.
constexpr int columns_at_once = 128;

/// Unit forces on the components of the cells.
linear_algebra::SparseLoads unit_loads(const ContactCells& cells, const SkinParts& parts) {
  linear_algebra::SparseLoads loads;
  const DenseMatrix& unit = cells.unit_load;
  for (int j = 0; j < unit.columns; ++j) {
    for (int row = 0; row < unit.rows; ++row) {
      if (unit(row, j) != 0) {
        loads.place.push_back(parts.load_place[row]);
        loads.value.push_back(unit(row, j));
      }
    }
    loads.start.push_back(static_cast<int>(loads.place.size()));
  }
  return loads;
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
                       const std::vector<ElasticLaw>& law_of_row) {
  const ElasticSystem system = assemble(part.space, lines, law_of_row);
  auto cholesky = std::make_unique<linear_algebra::Cholesky>(part.symbolic, system.stiffness);
  schur_ = linear_algebra::gram_of_rows(cholesky->take_last_block(part.interface));
  cholesky_ = std::move(cholesky);
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
                         const mesh::MeshLines& lines, const std::vector<ElasticLaw>& law_of_row)
    : factor(*parts.inner.part, lines, law_of_row),
      loads(factor.cholesky().forward(unit_loads(cells, parts))), compliance(loads.gram()) {}

const DenseMatrix& SkinDisplacement::of_skin(int first, int count) {
  of_skin_.reshape(static_cast<int>(parts_.unknown.size()), count);
  for (int i = 0; i < of_skin_.rows; ++i) {
    const PartUnknown& unknown = parts_.unknown[static_cast<std::size_t>(i)];
    const DenseMatrix& part =
        unknown.part == 0 ? inner_ : outer_[static_cast<std::size_t>(unknown.part - 1)];
    const double* from = part.column(unknown.place) + first;
    for (int j = 0; j < count; ++j) {
      of_skin_(i, j) = unknown.sign * from[j];
    }
  }
  return of_skin_;
}

FactorisedSkin::Place::Place(std::counting_semaphore<>& places) : places_(places) {
  places_.acquire();
}

FactorisedSkin::Place::~Place() {
  base::return_free_memory();
  places_.release();
}

FactorisedSkin::FactorisedSkin(const ElasticSkin& skin, const mesh::MeshLines& lines, int threads,
                               parallel::SpareThreads* spare)
    : place_(skin.analysis(threads).free_factors),
      threads_(skin.analysis().factors_at_once == 1 ? threads : 1),
      kernel_threads_(skin.analysis().factors_at_once == 1 ? lone_factor_threads : 1),
      spare_(spare), parts_(skin.analysis().parts) {
  factorise_parts(skin, lines);
  base::check_interrupt();
  join();
  gather_reactions(skin.space.unknowns());
}

void FactorisedSkin::run_tasks(std::size_t count,
                               const std::function<void(std::size_t)>& task) const {
  if (spare_ != nullptr && threads_ == 1) {
    parallel::run_tasks_with_help(count, *spare_, task);
  } else {
    parallel::run_tasks(count, threads_, task);
  }
}

void FactorisedSkin::factorise_parts(const ElasticSkin& skin, const mesh::MeshLines& lines) {
  const mesh::MeshLines inner_lines = parts_.inner_lines(skin.cells, lines);
  const auto inner = skin.analysis().inner(inner_lines);
  const auto take_inner = [&] {
    inner_ = inner->get([&] {
      return std::make_unique<const InnerFactor>(parts_, skin.cells, inner_lines, skin.law_of_row);
    });
  };
  // The inner part takes longest: it is begun first, unless another position makes it already.
  const bool begins = inner->begin();
  const std::size_t outer = begins ? 1 : 0;
  std::vector<std::optional<PartFactor>> made(parts_.outer.size());
  run_tasks(outer + made.size(), [&](std::size_t task) {
    base::check_interrupt();
    if (task < outer) {
      take_inner();
      return;
    }
    const PlacedPart& placed = parts_.outer[task - outer];
    made[task - outer].emplace(*placed.part, parts_.outer_lines(placed, lines), skin.law_of_row);
  });
  if (!begins) {
    take_inner();
  }
  for (auto& factor : made) {
    outer_.push_back(std::move(*factor));
  }
}

void FactorisedSkin::join() {
  const linear_algebra::KernelThreads kernel_threads(kernel_threads_);
  DenseMatrix stiffness = inner_->factor.schur().dense(); // its lower triangle alone is used
  for (std::size_t p = 0; p < outer_.size(); ++p) {
    const PlacedPart& placed = parts_.outer[p];
    const linear_algebra::LowerTriangle& own = outer_[p].schur();
    const double* sign = placed.sign.data() + placed.sign.size() - own.size();
    const int first = placed.first_interface;
    for (int j = 0; j < own.size(); ++j) {
      const double* column = own.column(j);
      for (int i = j; i < own.size(); ++i) {
        stiffness(first + i, first + j) += sign[i] * sign[j] * *column++;
      }
    }
    outer_[p].forget_schur();
  }
  if (!linear_algebra::factorise(stiffness.rows, stiffness.values.data(), stiffness.rows)) {
    throw SolverError("the stiffness matrix is not positive definite between the parts of the skin",
                      "check the elastic constants and layer thicknesses for extreme ratios");
  }
  interface_ = inner_->loads.passed_on();
  const int at_once = kernel_threads_ > 1 ? interface_.columns : columns_at_once;
  const auto solve = [&](bool transpose) {
    run_tasks(static_cast<std::size_t>((interface_.columns + at_once - 1) / at_once),
              [&](std::size_t block) {
                const int first = static_cast<int>(block) * at_once;
                linear_algebra::solve_left(transpose, interface_.rows,
                                           std::min(at_once, interface_.columns - first),
                                           stiffness.values.data(), stiffness.rows,
                                           interface_.column(first), interface_.rows);
              });
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
  std::vector<int> loads;
  for (int cell = first; cell < first + count; ++cell) {
    loads.push_back(3 * cell + direction);
  }
  result.inner_.reshape(count, parts_.inner.part->space.unknowns());
  inner_->loads.select(loads, result.inner_);
  complete(states_of(interface_, direction, first, count), result);
}

void FactorisedSkin::displacement(const DenseMatrix& forces, SkinDisplacement& result) const {
  result.inner_.reshape(forces.columns, parts_.inner.part->space.unknowns());
  inner_->loads.combine(forces, result.inner_);
  complete(transposed(linear_algebra::multiply(interface_, forces)), result);
}

void FactorisedSkin::complete(const DenseMatrix& interface, SkinDisplacement& result) const {
  const int states = interface.rows;
  DenseMatrix& inner = result.inner_;
  const int inside = inner.columns - interface.columns;
  std::ranges::copy(interface.values, inner.column(inside));
  inner_->factor.cholesky().complete(interface.columns, inside, inner);
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
