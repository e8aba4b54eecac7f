// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/handover/strain_grid.hpp"
#include "ionskin/history/core_history.hpp"
#include "ionskin/history/line_operators.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::handover {

/// Continues a field on the half y <= width / 2 of the skin by reflection to the whole width,
/// [z][y][x] with twice the rows.
/// @param half [z][y][x]
/// @param levels,rows,columns number of values of `half` along z, y and x
history::StrainField reflected_field(const history::StrainField& half, std::size_t levels,
                                     std::size_t rows, std::size_t columns);

/// Projection of a scalar field from the points of `mechanics::CoreStrain` to the grid of the
/// strain history, which moves with the slider: means over the cells in the plane, continuous and
/// linear through the thickness.
class FieldProjection {
public:
  /// Makes the grid and the projection through the thickness.
  /// @param mesh must outlive this object
  /// @param box all positions of the slider's centre [m]
  FieldProjection(const Case& input, const mesh::SkinMesh& mesh, const MotionBox& box);

  /// Grid of the strain history.
  const history::StrainGrid& grid() const { return grid_; }
  /// Projects a field, with the slider's centre at one position. The result covers the whole width.
  /// @param at_points values at the points, [z][y][x], of the half y <= width / 2 if the mesh is a
  /// half model
  /// @param points number of points along x, y, z
  /// @param centre position of the slider's centre, from the skin's corner [m]
  history::StrainField at(std::vector<double> at_points, const std::array<std::size_t, 3>& points,
                          const std::array<double, 2>& centre) const;

private:
  const mesh::SkinMesh& mesh_;
  CoreGrid core_;
  history::StrainGrid grid_;
  history::LineOperator along_z_;
};

} // namespace ionskin::handover
