// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/fields/depth_table.hpp"
#include "ionskin/finite_layers/fields/face_motion.hpp"
#include "ionskin/finite_layers/fields/face_strain.hpp"
#include "ionskin/finite_layers/fields/plane_waves.hpp"

#include <vector>

namespace ionskin::finite_layers {

/// Points or intervals along a skin; each of x meets each of y.
struct FieldPlaces {
  std::vector<Interval> x, y;
};

/// Levels in a skin.
struct FieldLevels {
  std::vector<DepthLevel> levels;
  std::vector<double> cutoffs; ///< wave number that is felt at each level [1/m]
};

/// A rectangle of the skin whose modes are summed [m].
struct PlaneBox {
  double x = 0, y = 0; ///< corner
  double length = 0, width = 0;
};

/// Strain at some levels, with what is tabulated for them.
class FieldTarget {
public:
  /// @param sides,ends their modes: of the sides even and, without a mirror, odd across the skin;
  /// of
  ///        the ends in the order of their motions
  FieldTarget(const FieldSkin& skin, FieldLevels levels, const std::vector<FaceModes>& sides,
              const std::vector<FaceModes>& ends);

  const FieldLevels& levels() const { return levels_; }
  /// Zero at all places, [x, y + y's count * level].
  Strains none(const FieldPlaces& places) const;
  /// Adds waves of a box, and what the motion of the sides adds to those of the whole skin.
  /// @param motion null for a box that is not the skin
  void add_waves(const PlaneWaves& waves, const PlaneWaves::Tractions& tractions,
                 const PlaneBox& box, const FaceMotion* motion, const FieldPlaces& places,
                 Strains& sum) const;
  void add_ends(const FaceMotion& motion, const FieldPlaces& places, Strains& sum) const;

private:
  FieldLevels levels_;
  DepthTable depth_;
  double width_; ///< of the skin
  std::vector<FaceStrain> sides_, ends_;
};

} // namespace ionskin::finite_layers
