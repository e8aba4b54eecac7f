// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/condensed_position.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/largest.hpp"
#include "ionskin/base/system/free_memory.hpp"
#include "ionskin/linear_algebra/dense_kernels.hpp"
#include "ionskin/mechanics/elasticity/elastic_system.hpp"
#include "ionskin/mechanics/position/position_input.hpp"
#include "ionskin/mechanics/position/position_memory.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace ionskin::mechanics {
namespace {

using linear_algebra::DenseMatrix;

/// States, or unit forces, recovered in one blocked solve; bounds the memory.
constexpr int block_size = 64;

/// Threads of the kernels of a factor that the memory holds only one of at a time. BLAS splits its
/// sums by the number of threads, so it is the same whatever number a run is given.
constexpr int lone_factor_threads = 2;

DenseMatrix matrix_of(const std::vector<CellVector>& forces, std::size_t first, int count) {
  DenseMatrix block(static_cast<int>(forces[first].size()), count);
  for (int j = 0; j < count; ++j) {
    const CellVector& force = forces[first + static_cast<std::size_t>(j)];
    std::copy(force.begin(), force.end(), block.column(j));
  }
  return block;
}

double equilibrium_residual(const ElasticSpace& space, const std::array<double, 3>& reaction,
                            const double* force, int components) {
  // Force components are normal (downwards), x, y; the base pushes back along x, y, z.
  constexpr std::array<std::size_t, 3> direction{2, 0, 1};
  double worst = 0, largest = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    double load = 0;
    for (int at = static_cast<int>(c); at < components; at += 3) {
      load += c == 0 ? -force[at] : force[at];
    }
    largest = base::larger(largest, std::abs(load));
    if (space.held_by_base_alone(static_cast<int>(direction[c]))) {
      worst = base::larger(worst, std::abs(load - reaction[direction[c]]));
    }
  }
  return largest == 0 && worst == 0 ? 0.0 : worst / largest;
}

bool holds(const StoredPosition& position, const ForceDirections& directions) {
  return std::ranges::all_of(std::array<std::size_t, 3>{0, 1, 2},
                             [&](std::size_t d) { return position.response[d] || !directions[d]; });
}

} // namespace

/// The factor of one position, and its place among the factors that fit into the memory.
class CondensedPosition::Factorised {
public:
  Factorised(const ElasticSkin& skin, const mesh::MeshLines& lines)
      : place_(skin.analysis().free_factors),
        threads_(skin.analysis().factors_at_once == 1 ? lone_factor_threads : 1), base_reaction_{} {
    ElasticSystem system = assemble(skin.space, lines, skin.law_of_row);
    factor_ = std::make_unique<linear_algebra::Cholesky>(skin.analysis().symbolic, system.stiffness,
                                                         threads_);
    base_reaction_ = std::move(system.base_reaction);
    forward_ = factor_->trailing_forward(skin.cells.unit_load);
  }

  DenseMatrix compliance() const {
    const linear_algebra::KernelThreads kernel_threads(threads_);
    return linear_algebra::gram(forward_);
  }

  /// Displacement of all unknowns under unit forces in one direction on the cells from `first` on;
  /// shape [unknowns, count].
  DenseMatrix unit_displacement(int direction, int first, int count) const {
    DenseMatrix block(forward_.rows, count);
    for (int j = 0; j < count; ++j) {
      const double* from = forward_.column(3 * (first + j) + direction);
      std::copy(from, from + forward_.rows, block.column(j));
    }
    return factor_->backward_from_trailing(block);
  }
  /// The same under given forces; shapes [3 cells, any] to [unknowns, any].
  DenseMatrix displacement(const DenseMatrix& forces) const {
    return factor_->backward_from_trailing(linear_algebra::multiply(forward_, forces));
  }

  std::array<double, 3> base_reaction(const double* displacement) const {
    std::array<double, 3> result{};
    for (std::size_t r = 0; r < 3; ++r) {
      result[r] =
          std::inner_product(base_reaction_[r].begin(), base_reaction_[r].end(), displacement, 0.0);
    }
    return result;
  }

private:
  /// Waits until the memory holds one more factor. The first member, it goes when the factor is
  /// gone.
  class Place {
  public:
    explicit Place(std::counting_semaphore<>& places) : places_(places) { places_.acquire(); }
    ~Place() {
      base::return_free_memory();
      places_.release();
    }
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

  private:
    std::counting_semaphore<>& places_;
  };

  Place place_;
  int threads_;
  std::array<std::vector<double>, 3> base_reaction_;
  std::unique_ptr<linear_algebra::Cholesky> factor_;
  DenseMatrix forward_; ///< L22^-1 B of the unit loads, [footprint unknowns, 3 cells]
};

CondensedPosition::CondensedPosition(const SkinModel& model, const std::array<double, 2>& centre,
                                     const PositionUse& use)
    : CondensedPosition(model, model.mesh.lines(centre), use) {}

CondensedPosition::CondensedPosition(const ElasticSkin& skin, mesh::MeshLines lines,
                                     const PositionUse& use)
    : skin_(skin), lines_(std::move(lines)), lattice_(skin.space, skin.core_z),
      membrane_(skin.space, lines_, skin.law_of_row, skin.layer_of_row, skin.core_z) {
  const int cells = static_cast<int>(skin.cells.count());
  if (!responses_fit(lattice_.rows(), membrane_.rows(), 3 * cells)) {
    factorise();
    stored_ = std::make_shared<const StoredPosition>(
        StoredPosition{factorised_->compliance(), UnitResponse{}});
    return;
  }
  ForceDirections directions = use.forces;
  PositionMemory& memory = PositionMemory::of_process();
  const base::Digest key = use.cache != nullptr ? position_key(skin, lines_) : base::Digest{};
  if (use.cache != nullptr) {
    if (stored_ = memory.find(key); stored_ && holds(*stored_, directions)) {
      return;
    }
    stored_ = read_position(*use.cache, key, lattice_.rows(), membrane_.rows(), cells);
    if (stored_ && holds(*stored_, directions)) {
      memory.keep(key, stored_);
      return;
    }
    for (std::size_t d = 0; stored_ && d < directions.size(); ++d) {
      directions[d] = directions[d] || stored_->response[d]; // of an entry that is replaced
    }
  }
  factorise();
  auto made = std::make_shared<StoredPosition>();
  made->compliance = factorised_->compliance();
  for (std::size_t d = 0; d < directions.size(); ++d) {
    if (directions[d]) {
      made->response[d] = unit_response(static_cast<int>(d));
    }
  }
  factorised_.reset();
  stored_ = std::move(made);
  if (use.cache != nullptr) {
    write_position(*use.cache, key, stored_->compliance, stored_->response);
    memory.keep(key, stored_);
  }
}

CondensedPosition::~CondensedPosition() = default;

void CondensedPosition::factorise() {
  factorised_ = std::make_unique<Factorised>(skin_, lines_);
}

DirectionResponse CondensedPosition::unit_response(int direction) const {
  const int cells = static_cast<int>(skin_.cells.count());
  DirectionResponse result{
      {lattice_.rows(), cells}, {membrane_.rows(), cells}, DenseMatrix(3, cells)};
  std::vector<double> lattice(static_cast<std::size_t>(lattice_.rows())),
      membrane(static_cast<std::size_t>(membrane_.rows()));
  for (int first = 0; first < cells; first += block_size) {
    const int count = std::min(block_size, cells - first);
    const DenseMatrix displacement = factorised_->unit_displacement(direction, first, count);
    for (int j = 0; j < count; ++j) {
      lattice_.gather(displacement.column(j), lattice.data());
      membrane_.average_strain(displacement.column(j), membrane.data());
      result.core.set_column(first + j, lattice.data());
      result.membrane.set_column(first + j, membrane.data());
      const auto reaction = factorised_->base_reaction(displacement.column(j));
      std::copy(reaction.begin(), reaction.end(), result.base_reaction.column(first + j));
    }
  }
  return result;
}

CondensedPosition::Response CondensedPosition::response(const double* lattice,
                                                        const double* membrane,
                                                        const std::array<double, 3>& reaction,
                                                        const double* force) const {
  return {lattice_.strain(lines_, lattice),
          membrane_.largest_stress(membrane),
          equilibrium_residual(skin_.space, reaction, force, compliance().columns),
          {membrane, membrane + membrane_.rows()}};
}

void CondensedPosition::respond_by_products(const DenseMatrix& forces,
                                            std::vector<Response>& responses) const {
  const int cells = compliance().columns / 3;
  DenseMatrix core(lattice_.rows(), forces.columns), strain(membrane_.rows(), forces.columns),
      direct(cells, forces.columns);
  std::vector<std::array<double, 3>> reaction(static_cast<std::size_t>(forces.columns));
  for (int d = 0; d < 3; ++d) {
    for (int k = 0; k < forces.columns; ++k) {
      for (int cell = 0; cell < cells; ++cell) {
        direct(cell, k) = forces(3 * cell + d, k);
      }
    }
    const auto& unit = stored_->response[static_cast<std::size_t>(d)];
    if (!unit) {
      if (std::ranges::any_of(direct.values, [](double force) { return force != 0; })) {
        throw InternalError("a slider position has no response in the direction of a force");
      }
      continue;
    }
    multiply_add(unit->core, direct, core);
    multiply_add(unit->membrane, direct, strain);
    for (int k = 0; k < forces.columns; ++k) {
      for (int cell = 0; cell < cells; ++cell) {
        for (int r = 0; r < 3; ++r) {
          reaction[k][r] += unit->base_reaction(r, cell) * direct(cell, k);
        }
      }
    }
  }
  for (int k = 0; k < forces.columns; ++k) {
    responses.push_back(response(core.column(k), strain.column(k), reaction[k], forces.column(k)));
  }
}

void CondensedPosition::respond_by_factor(const DenseMatrix& forces,
                                          std::vector<Response>& responses) const {
  std::vector<double> lattice(static_cast<std::size_t>(lattice_.rows())),
      membrane(static_cast<std::size_t>(membrane_.rows()));
  const DenseMatrix displacement = factorised_->displacement(forces);
  for (int k = 0; k < forces.columns; ++k) {
    lattice_.gather(displacement.column(k), lattice.data());
    membrane_.average_strain(displacement.column(k), membrane.data());
    responses.push_back(response(lattice.data(), membrane.data(),
                                 factorised_->base_reaction(displacement.column(k)),
                                 forces.column(k)));
  }
}

std::vector<CondensedPosition::Response>
CondensedPosition::respond(const std::vector<CellVector>& forces) const {
  std::vector<Response> responses;
  for (std::size_t first = 0; first < forces.size(); first += block_size) {
    const int count = static_cast<int>(std::min<std::size_t>(block_size, forces.size() - first));
    const DenseMatrix block = matrix_of(forces, first, count);
    if (factorised_) {
      respond_by_factor(block, responses);
    } else {
      respond_by_products(block, responses);
    }
  }
  return responses;
}

DenseMatrix contact_compliance(const SkinModel& model, const CondensedPosition& position) {
  DenseMatrix compliance = position.compliance();
  for (std::size_t at = 0; at < model.slider_compliance.values.size(); ++at) {
    compliance.values[at] += model.slider_compliance.values[at];
  }
  return compliance;
}

} // namespace ionskin::mechanics
