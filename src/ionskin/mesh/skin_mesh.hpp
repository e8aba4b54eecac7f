// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::mesh {

/// Element lines of a tensor-product hexahedral mesh in the skin's frame [m], ascending.
/// x and y count from the skin's corner, z from the bottom of the lowest layer.
struct MeshLines {
  std::vector<double> x, y, z;
  bool operator==(const MeshLines&) const = default;
};

/// Half the skin suffices where the motion lies on the symmetry plane.
enum class MeshedPart { half_if_symmetric, whole };

/// The slider-attached mesh of one case: a fixed topology whose lines stay on the slider's edges
/// while the parts outside the footprint stretch smoothly with the slider's position, so that every
/// result is a smooth function of the position along the track. Mirrored positions have mirrored
/// lines.
class SkinMesh {
public:
  /// Builds the element counts once for all positions of the track. Without a footprint it takes
  /// the largest that the slider can have.
  /// Throws UserError when the slider comes so close to the skin's edge that no element fits
  /// between.
  explicit SkinMesh(const Case& input, MeshedPart part = MeshedPart::half_if_symmetric);
  SkinMesh(const Case& input, const Footprint& footprint,
           MeshedPart part = MeshedPart::half_if_symmetric);

  /// Lines for a slider centred at `centre` [m]. The half model spans y in [0, width / 2].
  MeshLines lines(const std::array<double, 2>& centre) const;

  /// Lines along y alone [m].
  std::vector<double> lines_across(double centre_y) const;

  /// True when only y <= width / 2 is meshed, as the motion lies on the symmetry plane y = width /
  /// 2.
  bool half_model() const { return half_model_; }
  /// First and one-past-last element index of the footprint along x and y.
  std::array<std::size_t, 2> footprint_x() const {
    return {x_.outer, x_.outer + x_.inner_elements()};
  }
  std::array<std::size_t, 2> footprint_y() const {
    return {y_.outer, y_.outer + y_.inner_elements()};
  }
  /// Horizontal axis along which the slider goes the longest way.
  std::size_t main_axis() const { return main_axis_; }
  /// Footprint lines from the slider's centre [m]; half models end at 0 along y.
  const std::vector<double>& footprint_lines_x() const { return x_.inner; }
  const std::vector<double>& footprint_lines_y() const { return y_.inner; }
  const Footprint& footprint() const { return footprint_; }
  /// First and one-past-last element index of the core along z.
  std::array<std::size_t, 2> core_z() const { return core_z_; }
  /// Lines along z [m].
  const std::vector<double>& lines_z() const { return z_; }
  /// Index of the layer that holds each element row along z.
  const std::vector<std::size_t>& layer_of_row() const { return layer_of_row_; }
  /// Elements along x, y and z.
  std::array<std::size_t, 3> elements() const;
  /// Displacement unknowns of the Q2 discretisation before constraints.
  std::size_t unknowns() const;

private:
  /// One horizontal direction of the tensor product.
  struct Axis {
    double extent = 0;    ///< of the meshed skin [m]
    bool centred = false; ///< the footprint stays in the middle of the skin: symmetry or full cover
    bool half = false;    ///< only the lower half is meshed
    std::vector<double> inner; ///< footprint lines from the slider's centre [m]
    /// Elements before and, in full models, behind the footprint, those of `face` included.
    std::size_t outer = 0;
    double outer_first = 0; ///< size of the outer elements at the footprint [m]
    /// Lines of the edge layer at a free face, from the face inwards [m]; 0 alone without one.
    std::vector<double> face{0.0};

    std::size_t inner_elements() const { return inner.size() - 1; }
    std::size_t elements() const { return inner_elements() + (half ? 1 : 2) * outer; }
    std::vector<double> lines(double centre, double skin_size) const;
    /// Lines from the footprint to the face [m]. @param length between them [m]
    std::vector<double> outer_lines(double length) const;
  };

  Axis make_axis(const Case& input, std::size_t direction) const;

  Skin skin_;
  Footprint footprint_;
  bool half_model_ = false;
  std::size_t main_axis_ = 0;
  Axis x_, y_;
  std::array<std::size_t, 2> core_z_{};
  std::vector<std::size_t> layer_of_row_;
  std::vector<double> z_;
};

} // namespace ionskin::mesh
