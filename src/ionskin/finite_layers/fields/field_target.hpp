// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/fields/depth_table.hpp"
#include "ionskin/finite_layers/fields/face_motion.hpp"
#include "ionskin/finite_layers/fields/face_strain.hpp"
#include "ionskin/finite_layers/fields/plane_waves.hpp"

#include <vector>

namespace ionskin::finite_layers {

/// A tensor grid in a skin: points or intervals along it, and levels.
struct FieldPlaces {
  std::vector<Interval> x, y;
  std::vector<DepthLevel> levels;
  std::vector<double> cutoffs; ///< wave number that is felt at each level [1/m]
};

/// A rectangle of the skin whose modes are summed [m].
struct PlaneBox {
  double x = 0, y = 0; ///< corner
  double length = 0, width = 0;
};

/// Strain at the places of a grid, with what is tabulated for it.
class FieldTarget {
public:
  /// @param sides,ends their modes: of the sides even and, without a mirror, odd across the skin;
  /// of
  ///        the ends in the order of their motions
  FieldTarget(const LayeredSkin& skin, FieldPlaces places, const std::vector<FaceModes>& sides,
              const std::vector<FaceModes>& ends);

  const FieldPlaces& places() const { return places_; }
  /// Zero at all places, [x, y + y's count * level].
  Strains none() const;
  /// Adds waves of a box, and what the motion of the sides adds to those of the whole skin.
  /// @param motion null for a box that is not the skin
  void add_waves(const PlaneWaves& waves, const PlaneWaves::Tractions& tractions,
                 const PlaneBox& box, const FaceMotion* motion, Strains& sum) const;
  void add_ends(const FaceMotion& motion, Strains& sum) const;

private:
  FieldPlaces places_;
  DepthTable depth_;
  double width_; ///< of the skin
  std::vector<FaceStrain> sides_, ends_;
};

} // namespace ionskin::finite_layers
