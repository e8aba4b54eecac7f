// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/digest.hpp"
#include "ionskin/base/files/disk_cache.hpp"
#include "ionskin/linear_algebra/fixed_point_matrix.hpp"

#include <array>
#include <memory>
#include <optional>

namespace ionskin::mechanics {

/// Directions of a cell's force: normal, x, y.
using ForceDirections = std::array<bool, 3>;

/// What the skin does under a unit force on each contact cell in one direction.
struct DirectionResponse {
  linear_algebra::FixedPointMatrix core;     ///< CoreLattice by cell [m/N]
  linear_algebra::FixedPointMatrix membrane; ///< ElectrodeMembrane by cell [1/N]
  linear_algebra::DenseMatrix base_reaction; ///< x, y, z by cell [1]
};
/// Normal, x, y; empty where no force is asked for. Every state at this position is a product with
/// it, at any friction and load, without a factorisation.
using UnitResponse = std::array<std::optional<DirectionResponse>, 3>;

/// Positions that a slide has, or more.
inline constexpr std::size_t least_positions = 4;

/// Whether the responses of so many positions, at least four, fit into the default bound of the
/// cache. Mesh and path alone decide, not what is in the memory or the cache: states by a response
/// are rounded otherwise than by the factor.
bool responses_fit(int core_rows, int membrane_rows, int components, std::size_t positions);

/// What is kept of a condensed position.
struct StoredPosition {
  linear_algebra::DenseMatrix compliance; ///< of the contact components [m/N]
  UnitResponse response;
};

/// @param core_rows,membrane_rows sizes that an entry of this model must have
/// Null where there is none, or a damaged one.
std::shared_ptr<const StoredPosition> read_position(base::DiskCache& cache, const base::Digest& key,
                                                    int core_rows, int membrane_rows, int cells);
/// Keeps nothing where so many positions of a path exceed the bound of the cache: each would drive
/// out one that the next run asks for first.
void write_position(base::DiskCache& cache, const base::Digest& key, const StoredPosition& position,
                    std::size_t positions);

} // namespace ionskin::mechanics
