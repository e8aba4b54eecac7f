// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/condensed_position.hpp"

#include "ionskin/base/free_memory.hpp"
#include "ionskin/linear_algebra/dense_kernels.hpp"
#include "ionskin/mechanics/elastic_system.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace ionskin::mechanics {
namespace {

using linear_algebra::DenseMatrix;

/// States, or unit forces, recovered in one blocked solve; bounds the memory.
constexpr int block_size = 64;

DenseMatrix matrix_of(const std::vector<CellVector>& forces, std::size_t first, int count) {
  DenseMatrix block(static_cast<int>(forces[first].size()), count);
  for (int j = 0; j < count; ++j) {
    const CellVector& force = forces[first + static_cast<std::size_t>(j)];
    std::copy(force.begin(), force.end(), block.column(j));
  }
  return block;
}

double equilibrium_residual(const ElasticSpace& space, const std::array<double, 3>& reaction,
                            const CellVector& force) {
  // Force components are normal (downwards), x, y; the base pushes back along x, y, z.
  constexpr std::array<std::size_t, 3> direction{2, 0, 1};
  double worst = 0, largest = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    double load = 0;
    for (std::size_t at = c; at < force.size(); at += 3) {
      load += c == 0 ? -force[at] : force[at];
    }
    largest = std::max(largest, std::abs(load));
    if (space.held_by_base_alone(static_cast<int>(direction[c]))) {
      worst = std::max(worst, std::abs(load - reaction[direction[c]]));
    }
  }
  return largest > 0 ? worst / largest : 0.0;
}

} // namespace

/// The factor of one position, and its place among the factors that fit into the memory.
class CondensedPosition::Factorised {
public:
  /// @param threads to use where it is alone
  Factorised(const SkinModel& model, const mesh::MeshLines& lines, int threads)
      : place_(model.analysis().free_factors),
        threads_(model.analysis().factors_at_once == 1 ? threads : 1), base_reaction_{} {
    ElasticSystem system = assemble(model.space, lines, model.law_of_row);
    factor_ = std::make_unique<linear_algebra::Cholesky>(model.analysis().symbolic,
                                                         system.stiffness, threads_);
    base_reaction_ = std::move(system.base_reaction);
    forward_ = factor_->trailing_forward(model.cells.unit_load);
  }

  DenseMatrix compliance() const {
    const linear_algebra::KernelThreads kernel_threads(threads_);
    return linear_algebra::gram(forward_);
  }

  /// Displacement of all unknowns under unit forces from `first` on; shape [unknowns, count].
  DenseMatrix unit_displacement(int first, int count) const {
    DenseMatrix block(forward_.rows, count);
    std::copy(forward_.column(first), forward_.column(first) + block.values.size(),
              block.values.begin());
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
                                     const PositionStore& store, int threads)
    : model_(model), lines_(model.mesh.lines(centre)), lattice_(model.space, model.mesh.core_z()),
      membrane_(model.space, lines_, model.law_of_row, model.mesh.layer_of_row(),
                model.mesh.core_z()) {
  const bool caches = store.cache != nullptr;
  const base::Digest key = caches ? position_key(model, lines_) : base::Digest{};
  bool came_before = false;
  if (caches) {
    auto stored = read_position(*store.cache, key, lattice_.rows(), membrane_.rows(),
                                model.cells.unit_load.columns);
    if (stored && stored->response) {
      compliance_ = std::move(stored->compliance);
      response_ = std::move(stored->response);
      return;
    }
    came_before = stored.has_value();
  }
  factorised_ = std::make_unique<Factorised>(model, lines_, threads);
  compliance_ = factorised_->compliance();
  if (!caches) {
    return;
  }
  if ((store.many_states || came_before) &&
      has_room_for_responses(*store.cache, lattice_.rows(), membrane_.rows(),
                             compliance_.columns)) {
    response_ = unit_response();
    factorised_.reset();
  }
  write_position(*store.cache, key, compliance_, response_ ? &*response_ : nullptr);
}

CondensedPosition::~CondensedPosition() = default;

UnitResponse CondensedPosition::unit_response() const {
  const int components = compliance_.columns;
  UnitResponse result{
      {lattice_.rows(), components}, {membrane_.rows(), components}, DenseMatrix(3, components)};
  std::vector<double> lattice(static_cast<std::size_t>(lattice_.rows())),
      membrane(static_cast<std::size_t>(membrane_.rows()));
  for (int first = 0; first < components; first += block_size) {
    const int count = std::min(block_size, components - first);
    const DenseMatrix displacement = factorised_->unit_displacement(first, count);
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
                                                        const CellVector& force) const {
  return {lattice_.strain(lines_, lattice), membrane_.largest_stress(membrane),
          equilibrium_residual(model_.space, reaction, force)};
}

std::vector<CondensedPosition::Response>
CondensedPosition::respond(const std::vector<CellVector>& forces) const {
  std::vector<Response> responses;
  std::vector<double> lattice(static_cast<std::size_t>(lattice_.rows())),
      membrane(static_cast<std::size_t>(membrane_.rows()));
  for (std::size_t first = 0; first < forces.size(); first += block_size) {
    const int count = static_cast<int>(std::min<std::size_t>(block_size, forces.size() - first));
    const DenseMatrix block = matrix_of(forces, first, count);
    const auto force = [&](int j) -> const CellVector& {
      return forces[first + static_cast<std::size_t>(j)];
    };
    if (response_) {
      const DenseMatrix core = multiply(response_->core, block),
                        strain = multiply(response_->membrane, block),
                        reaction = linear_algebra::multiply(response_->base_reaction, block);
      for (int j = 0; j < count; ++j) {
        responses.push_back(response(core.column(j), strain.column(j),
                                     {reaction(0, j), reaction(1, j), reaction(2, j)}, force(j)));
      }
    } else {
      const DenseMatrix displacement = factorised_->displacement(block);
      for (int j = 0; j < count; ++j) {
        lattice_.gather(displacement.column(j), lattice.data());
        membrane_.average_strain(displacement.column(j), membrane.data());
        responses.push_back(response(lattice.data(), membrane.data(),
                                     factorised_->base_reaction(displacement.column(j)), force(j)));
      }
    }
  }
  return responses;
}

} // namespace ionskin::mechanics
