// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ionskin::results {

/// Values at points or cells, the components of one after the other.
struct VtuArray {
  std::string name, unit;
  std::vector<std::string> components; ///< names of several; empty for one
  std::vector<float> values;
};

/// Cells of one kind between points.
struct VtuGrid {
  enum class Cell : std::uint8_t { quadrilateral = 9, hexahedron = 12 }; // numbers of VTK
  Cell cell = Cell::hexahedron;
  std::vector<double> points;         ///< x, y, z of each [m]
  std::vector<std::int64_t> vertices; ///< of each cell: anticlockwise, the lower face first
  std::vector<VtuArray> at_points, at_cells;

  /// Hexahedra between lines, x fastest.
  static VtuGrid between(const std::vector<double>& x, const std::vector<double>& y,
                         const std::vector<double>& z);
  /// Quadrilaterals between lines. @param heights of the crossings, [y][x]
  static VtuGrid surface(const std::vector<double>& x, const std::vector<double>& y,
                         const std::vector<double>& heights);
};

/// Writes VTK's XML format for unstructured grids, compressed.
/// Throws UserError when the file cannot be written.
void write_vtu(const std::filesystem::path& path, double time, const VtuGrid& grid);

} // namespace ionskin::results
