// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/digest.hpp"
#include "ionskin/base/disk_cache.hpp"
#include "ionskin/linear_algebra/fixed_point_matrix.hpp"
#include "ionskin/mechanics/skin_model.hpp"

#include <optional>

namespace ionskin::mechanics {

/// What the skin does under a unit force on each contact component: every state at this position is
/// a product with it, at any friction and load, without a factorisation.
struct UnitResponse {
  linear_algebra::FixedPointMatrix core;     ///< CoreLattice by component [m/N]
  linear_algebra::FixedPointMatrix membrane; ///< ElectrodeMembrane by component [1/N]
  linear_algebra::DenseMatrix base_reaction; ///< x, y, z by component [1]
};

/// Whether a cache has room for the responses of a slide: at least four positions.
bool has_room_for_responses(const base::DiskCache& cache, int core_rows, int membrane_rows,
                            int components);

/// What is kept of a condensed position.
struct StoredPosition {
  linear_algebra::DenseMatrix compliance; ///< of the contact components [m/N]
  /// Left out while it did not pay: making it takes as long as a factorisation.
  std::optional<UnitResponse> response;
};

/// Digest of everything a condensed position depends on: mesh, materials, boundary conditions,
/// contact cells, and the version of the numerical method.
base::Digest position_key(const SkinModel& model, const mesh::MeshLines& lines);

/// @param core_rows,membrane_rows sizes that an entry of this model must have
std::optional<StoredPosition> read_position(base::DiskCache& cache, const base::Digest& key,
                                            int core_rows, int membrane_rows, int components);
/// @param response may be null
void write_position(base::DiskCache& cache, const base::Digest& key,
                    const linear_algebra::DenseMatrix& compliance, const UnitResponse* response);

} // namespace ionskin::mechanics
