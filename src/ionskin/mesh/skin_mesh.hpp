// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::mesh {

/// Lines of a tensor-product mesh of the skin at one position of the slider, ascending [m]. x and y
/// are measured from the skin's corner, z from the bottom of the lowest layer.
struct MeshLines {
  std::vector<double> x, y, z;
  bool operator==(const MeshLines&) const = default;
};

/// Part of the skin that is meshed: the half at y <= width / 2 where the motion lies on the
/// symmetry plane y = width / 2 and the slider is symmetric about it, or always the whole skin.
enum class MeshedPart { half_if_symmetric, whole };

/// Mesh of the skin that moves with the slider. The numbers of elements are fixed. The lines under
/// the slider keep their distances from the slider's centre, and the lines outside stretch smoothly
/// as the slider moves, so that every result is a smooth function of the slider's position.
/// Mirrored positions have mirrored lines. The lines bound the cells of the contact and the columns
/// and levels of the core in which strain is sampled.
class SkinMesh {
public:
  /// Chooses the numbers of elements for all positions of the track, on the footprint of
  /// `largest_footprint`.
  /// Throws UserError when the slider comes so close to the skin's edge that no element fits
  /// between.
  explicit SkinMesh(const Case& input, MeshedPart part = MeshedPart::half_if_symmetric);
  /// Chooses the numbers of elements for all positions of the track, on a given footprint. Throws
  /// UserError as the constructor above.
  SkinMesh(const Case& input, const Footprint& footprint,
           MeshedPart part = MeshedPart::half_if_symmetric);

  /// Lines of the mesh for a slider centred at `centre`, x and y in the skin's frame [m]. In a half
  /// model y ends at width / 2.
  MeshLines lines(const std::array<double, 2>& centre) const;

  /// Lines along y for a slider centred at `centre_y`, in the skin's frame [m].
  std::vector<double> lines_across(double centre_y) const;

  /// True if only y <= width / 2 is meshed, because the motion lies on the symmetry plane y = width
  /// / 2.
  bool half_model() const { return half_model_; }
  /// Indices of the first element of the footprint along x and of the element behind its last one.
  std::array<std::size_t, 2> footprint_x() const {
    return {x_.outer, x_.outer + x_.inner_elements()};
  }
  /// Indices of the first element of the footprint along y and of the element behind its last one.
  std::array<std::size_t, 2> footprint_y() const {
    return {y_.outer, y_.outer + y_.inner_elements()};
  }
  /// Lines of the footprint along x, measured from the slider's centre [m].
  const std::vector<double>& footprint_lines_x() const { return x_.inner; }
  /// Lines of the footprint along y, measured from the slider's centre [m]; they end at 0 in a half
  /// model.
  const std::vector<double>& footprint_lines_y() const { return y_.inner; }
  const Footprint& footprint() const { return footprint_; }
  /// Indices of the first element of the core along z and of the element behind its last one.
  std::array<std::size_t, 2> core_z() const { return core_z_; }
  /// Lines along z from the bottom of the lowest layer, the same for every position of the slider
  /// [m].
  const std::vector<double>& lines_z() const { return z_; }
  /// Index of the layer that holds each row of elements along z; layers are counted from the
  /// bottom.
  const std::vector<std::size_t>& layer_of_row() const { return layer_of_row_; }
  /// Numbers of elements along x, y and z of the meshed part.
  std::array<std::size_t, 3> elements() const;

private:
  /// Lines along one horizontal direction, x or y.
  struct Axis {
    double extent = 0;    ///< length of the meshed part of the skin [m]
    bool centred = false; ///< true if the footprint stays in the middle: symmetry or full cover
    bool half = false;    ///< true if only the lower half is meshed
    std::vector<double> inner; ///< lines of the footprint, from the slider's centre [m]
    /// Number of elements before the footprint and, in full models, as many behind it; those of
    /// `face` are included.
    std::size_t outer = 0;
    double outer_first = 0; ///< size of the element next to the footprint outside [m]
    /// Lines of the layer at a free end or side of the skin, measured inwards from it [m]; only 0
    /// where there is no such layer, as at a side held by symmetry.
    std::vector<double> face{0.0};

    std::size_t inner_elements() const { return inner.size() - 1; }
    std::size_t elements() const { return inner_elements() + (half ? 1 : 2) * outer; }
    std::vector<double> lines(double centre, double skin_size) const;
    /// Lines from the footprint to the face of the skin, from 0.
    /// @param length distance between footprint and face [m]
    std::vector<double> outer_lines(double length) const;
  };

  Axis make_axis(const Case& input, std::size_t direction) const;

  Skin skin_;
  Footprint footprint_;
  bool half_model_ = false;
  Axis x_, y_;
  std::array<std::size_t, 2> core_z_{};
  std::vector<std::size_t> layer_of_row_;
  std::vector<double> z_;
};

} // namespace ionskin::mesh
