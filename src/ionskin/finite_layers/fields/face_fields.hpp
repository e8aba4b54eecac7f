// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/fields/face_motion.hpp"
#include "ionskin/finite_layers/fields/face_strain.hpp"
#include "ionskin/finite_layers/fields/field_components.hpp"

#include <cstddef>
#include <limits>
#include <vector>

namespace ionskin::finite_layers {

/// Points or intervals along a skin; each of x meets each of y.
struct FieldPlaces {
  std::vector<Interval> x, y;
};

/// Strain at some levels over the motion of sides and ends.
class FaceFields {
public:
  /// @param most modes along each face: the first alone have a mean over the whole plane
  FaceFields(const FieldSkin& skin, const std::vector<DepthLevel>& levels,
             const ComponentChoice& components,
             std::size_t most = std::numeric_limits<std::size_t>::max());

  /// Adds to the strains of states.
  /// @param sums as of FieldTarget
  void add(const std::vector<FaceMotion>& motions, const std::vector<FieldPlaces>& places,
           std::vector<ByKind>& sums) const;

private:
  void add_side(std::size_t side, const std::vector<FaceMotion>& motions,
                const std::vector<FieldPlaces>& places, std::vector<ByKind>& sums) const;
  void add_end(std::size_t end, const std::vector<FaceMotion>& motions,
               const std::vector<FieldPlaces>& places, std::vector<ByKind>& sums) const;

  FieldComponents components_;
  Eigen::Index levels_;
  double length_, width_; ///< of the skin [m]
  std::vector<FaceStrain> sides_, ends_;
};

} // namespace ionskin::finite_layers
