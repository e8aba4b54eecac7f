// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/fields/face_motion.hpp"
#include "ionskin/finite_layers/fields/face_strain.hpp"
#include "ionskin/finite_layers/fields/field_components.hpp"

#include <cstddef>
#include <limits>
#include <vector>

namespace ionskin::finite_layers {

/// Positions along a skin, as points or intervals: the grid of all pairs of an `x` and a `y`, from
/// the skin's corner [m].
struct FieldPlaces {
  std::vector<Interval> x, y;
};

/// Strain at several levels that the motion of the free sides and ends causes, docs/model.md (60).
class FaceFields {
public:
  /// Makes the operators from motions to strains.
  /// @param levels positions through the thickness
  /// @param components of the strain that are needed
  /// @param most largest number of modes along each face. 1 suffices for means over the whole
  /// plane, to which further modes do not contribute.
  FaceFields(const FieldSkin& skin, const std::vector<DepthLevel>& levels,
             const ComponentChoice& components,
             std::size_t most = std::numeric_limits<std::size_t>::max());

  /// Adds the strain that the motions cause.
  /// @param motions one entry per state
  /// @param places one entry per state
  /// @param sums one entry per state, in the layout of `FieldTarget::none` [1]
  void add(const std::vector<FaceMotion>& motions, const std::vector<FieldPlaces>& places,
           std::vector<ByKind>& sums) const;

private:
  void add_side(std::size_t side, const std::vector<FaceMotion>& motions,
                const std::vector<FieldPlaces>& places, std::vector<ByKind>& sums) const;
  void add_end(std::size_t end, const std::vector<FaceMotion>& motions,
               const std::vector<FieldPlaces>& places, std::vector<ByKind>& sums) const;

  FieldComponents components_;
  Eigen::Index levels_;
  /// Size of the skin [m].
  double length_, width_;
  std::vector<FaceStrain> sides_, ends_;
};

} // namespace ionskin::finite_layers
