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

/// A field of the half y <= width / 2, continued by reflection to the whole width.
/// @param levels, rows, columns of the half
history::StrainField reflected_field(const history::StrainField& half, std::size_t levels,
                                     std::size_t rows, std::size_t columns);

/// Projection from the points of mechanics::CoreStrain to a field on the grid that rides with
/// the slider: means over its cells, linear through the thickness.
class FieldProjection {
public:
  /// @param mesh outlives this
  /// @param box of the slider's centre
  FieldProjection(const Case& input, const mesh::SkinMesh& mesh, const MotionBox& box);

  const history::StrainGrid& grid() const { return grid_; }
  /// Field on the grid of the history, by projection, with the slider's centre at a place.
  /// @param at_points [z][y][x], of the half model where the mesh is one
  /// @param points along x, y, z
  history::StrainField at(std::vector<double> at_points, const std::array<std::size_t, 3>& points,
                          const std::array<double, 2>& centre) const;

private:
  const mesh::SkinMesh& mesh_;
  CoreGrid core_;
  history::StrainGrid grid_;
  history::LineOperator along_z_;
};

} // namespace ionskin::handover
