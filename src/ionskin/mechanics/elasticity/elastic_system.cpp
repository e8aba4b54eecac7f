// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/elasticity/elastic_system.hpp"

#include <algorithm>

namespace ionskin::mechanics {
namespace {

using Block = std::array<std::array<double, 3>, 3>;

/// Couples displacement r of node i with displacement s of node j:
/// lambda (d_r i, d_s j) + mu (d_s i, d_r j) + mu delta_rs (grad i, grad j).
Block stiffness_block(const std::array<std::array<double, 3>, 3>& scale, const ElasticLaw& law,
                      int i, int j) {
  const ReferenceElement& reference = reference_element();
  Block products, block;
  for (int r = 0; r < 3; ++r) {
    for (int s = 0; s < 3; ++s) {
      products[r][s] = scale[r][s] * reference.gradient_product[r][s][i][j];
    }
  }
  const double laplacian = products[0][0] + products[1][1] + products[2][2];
  for (int r = 0; r < 3; ++r) {
    for (int s = 0; s < 3; ++s) {
      block[r][s] = law.lame_lambda * products[r][s] + law.shear_modulus * products[s][r];
    }
    block[r][r] += law.shear_modulus * laplacian;
  }
  return block;
}

/// Adds the coupling of a row node with a column node of not larger number.
void add_to_stiffness(const ElasticSpace& space, int row_node, int column_node, int offset,
                      const Block& block, std::vector<double>& stiffness) {
  const std::vector<int>& column_start = space.pattern().column_start;
  const std::array<int, 3>&rows = space.unknown(row_node), &columns = space.unknown(column_node);
  const int column_end = std::max({columns[0], columns[1], columns[2]}) + 1;
  for (int s = 0; s < 3; ++s) {
    if (columns[s] < 0) {
      continue;
    }
    double* entry = stiffness.data() + column_start[columns[s]];
    if (row_node != column_node) {
      entry += column_end - columns[s] + offset;
    }
    for (int r = 0; r < 3; ++r) {
      if (rows[r] >= 0 && (row_node != column_node || rows[r] >= columns[s])) {
        *entry++ += block[r][s];
      }
    }
  }
}

void add_to_reaction(const ElasticSpace& space, int node, const Block& block,
                     std::array<std::vector<double>, 3>& reaction) {
  for (int r = 0; r < 3; ++r) {
    for (int s = 0; s < 3; ++s) {
      const int unknown = space.unknown(node)[s];
      if (unknown >= 0) {
        reaction[r][unknown] -= block[r][s];
      }
    }
  }
}

} // namespace

std::array<double, 3> element_size(const ElasticSpace& space, const mesh::MeshLines& lines,
                                   std::size_t element) {
  const auto [nx, ny, nz] = space.elements();
  const std::size_t i = element % nx, j = element / nx % ny, k = element / (nx * ny);
  return {lines.x[i + 1] - lines.x[i], lines.y[j + 1] - lines.y[j], lines.z[k + 1] - lines.z[k]};
}

ElasticSystem assemble(const ElasticSpace& space, const mesh::MeshLines& lines,
                       const std::vector<ElasticLaw>& law_of_row) {
  ElasticSystem system;
  system.stiffness.assign(space.pattern().row.size(), 0.0);
  for (std::vector<double>& reaction : system.base_reaction) {
    reaction.assign(static_cast<std::size_t>(space.unknowns()), 0.0);
  }
  const std::size_t layer_size = space.elements()[0] * space.elements()[1];
  for (std::size_t e = 0; e < space.element_count(); ++e) {
    const std::array<double, 3> size = element_size(space, lines, e);
    const ElasticLaw& law = law_of_row[e / layer_size];
    const double volume = size[0] * size[1] * size[2];
    std::array<std::array<double, 3>, 3> scale;
    for (int r = 0; r < 3; ++r) {
      for (int s = 0; s < 3; ++s) {
        scale[r][s] = volume / (size[r] * size[s]);
      }
    }
    const std::array<int, element_nodes>& nodes = space.nodes(e);
    for (int i = 0; i < element_nodes; ++i) {
      for (int j = 0; j < element_nodes; ++j) {
        const bool row_on_base = space.on_base(nodes[i]);
        if (nodes[i] < nodes[j] && !row_on_base) {
          continue;
        }
        const Block block = stiffness_block(scale, law, i, j);
        if (nodes[i] >= nodes[j]) {
          add_to_stiffness(space, nodes[i], nodes[j], space.row_offset(e, i, j), block,
                           system.stiffness);
        }
        if (row_on_base) {
          add_to_reaction(space, nodes[j], block, system.base_reaction);
        }
      }
    }
  }
  return system;
}

} // namespace ionskin::mechanics
