// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mesh/skin_mesh.hpp"

#include <array>
#include <cstddef>

namespace ionskin::mechanics {

/// How a contact cell's traction is spread over the cell along one direction. Evenly; or, between
/// sharp edges of the slider at +-a, like 1 / sqrt(a^2 - x^2), the traction under a rigid punch
/// (Johnson, Contact Mechanics, 1985, section 2.8, DOI 10.1017/CBO9781139171731), so that its
/// singularity need not be resolved by small cells.
class TractionProfile {
public:
  /// Of the footprint along a direction (0 for x, 1 for y). A slider that ends with the skin has no
  /// edge on it.
  TractionProfile(const mesh::SkinMesh& mesh, std::size_t direction);
  /// Between sharp edges at +-half_size from the slider's centre [m]; evenly when 0.
  explicit TractionProfile(double half_size) : sharp_half_size_(half_size) {}

  /// Whether the traction is spread evenly.
  bool even() const { return sharp_half_size_ == 0; }
  /// Means of the three quadratic shape functions of an element edge, from its first to its last
  /// node, weighted with the traction. @param from,to ends of the edge from the slider's centre [m]
  std::array<double, 3> mean_shape_values(double from, double to) const;
  /// The place in an edge below which a share of its traction lies [m].
  double place_of_share(double from, double to, double share) const;

private:
  double angle(double x) const;

  double sharp_half_size_;
};

} // namespace ionskin::mechanics
