// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ionskin::results {

/// Field on the points or on the cells of a `VtuGrid`, scalar or with several components.
struct VtuArray {
  std::string name, unit;              ///< an empty unit is not written
  std::vector<std::string> components; ///< names of the components; empty for a scalar
  std::vector<float> values;           ///< [point or cell][component]
};

/// Unstructured grid of VTK: points, cells of one kind between them, and fields.
struct VtuGrid {
  enum class Cell : std::uint8_t { quadrilateral = 9, hexahedron = 12 }; // numbers of VTK
  Cell cell = Cell::hexahedron;
  std::vector<double> points; ///< coordinates [point][x, y, z] [m]
  /// Indices of the points of each cell, [cell][4 or 8]: anticlockwise seen from above; the lower
  /// face of a hexahedron first.
  std::vector<std::int64_t> vertices;
  std::vector<VtuArray> at_points, at_cells; ///< fields

  /// Grid of hexahedra between lines along x, y and z [m]; points and cells are ordered [z][y][x].
  static VtuGrid between(const std::vector<double>& x, const std::vector<double>& y,
                         const std::vector<double>& z);
  /// Surface of quadrilaterals between lines along x and y [m].
  /// @param heights z where the lines cross, [y][x] [m]
  static VtuGrid surface(const std::vector<double>& x, const std::vector<double>& y,
                         const std::vector<double>& heights);
};

/// Writes a grid as a file of VTK's XML format for unstructured grids (.vtu), compressed.
/// @param time stored as the file's time [s]
/// Throws UserError when the file cannot be written.
void write_vtu(const std::filesystem::path& path, double time, const VtuGrid& grid);

} // namespace ionskin::results
