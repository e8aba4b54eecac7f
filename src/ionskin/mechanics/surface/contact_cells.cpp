// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/contact_cells.hpp"

#include <array>

namespace ionskin::mechanics {
namespace {

/// Relative sizes of the parts into which an element under a sharp edge is cut, from the edge
/// inwards. Traction grows there like the inverse root of the distance from the edge, and the error
/// of uniform tractions falls with the size of the first cell.
constexpr std::array<double, 3> parts_at_edge{1, 2, 4};

/// Lines of contact cells from the lines of the mesh along one direction [m].
/// @param at_begin,at_end true if the lines begin and end at sharp edges
std::vector<double> cell_lines(const std::vector<double>& lines, bool at_begin, bool at_end) {
  double whole = 0;
  for (const double part : parts_at_edge) {
    whole += part;
  }
  std::vector<double> from_begin, from_end;
  double place = 0;
  for (std::size_t i = 0; i + 1 < parts_at_edge.size(); ++i) {
    place += parts_at_edge[i] / whole;
    from_begin.push_back(lines[0] + place * (lines[1] - lines[0]));
    const double last = lines[lines.size() - 1];
    from_end.insert(from_end.begin(), last - place * (last - lines[lines.size() - 2]));
  }
  std::vector<double> result = lines;
  if (at_end && lines.size() > 2) {
    result.insert(result.end() - 1, from_end.begin(), from_end.end());
  }
  if (at_begin && lines.size() > 2) {
    result.insert(result.begin() + 1, from_begin.begin(), from_begin.end());
  }
  return result;
}

} // namespace

std::array<double, 2> ContactCells::middle(std::size_t cell) const {
  const std::size_t i = cell % columns(), j = cell / columns();
  return {(lines_x[i] + lines_x[i + 1]) / 2, (lines_y[j] + lines_y[j + 1]) / 2};
}

ContactCells contact_cells(const mesh::SkinMesh& mesh) {
  const bool sharp_x = mesh.footprint().sharp(0), sharp_y = mesh.footprint().sharp(1);
  ContactCells cells{cell_lines(mesh.footprint_lines_x(), sharp_x, sharp_x),
                     cell_lines(mesh.footprint_lines_y(), sharp_y, sharp_y && !mesh.half_model()),
                     {}};
  for (std::size_t j = 0; j < cells.rows(); ++j) {
    for (std::size_t i = 0; i < cells.columns(); ++i) {
      cells.area.push_back((cells.lines_x[i + 1] - cells.lines_x[i]) *
                           (cells.lines_y[j + 1] - cells.lines_y[j]));
    }
  }
  return cells;
}

} // namespace ionskin::mechanics
