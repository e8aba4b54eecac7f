// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/linear_algebra/sparse_matrix.hpp"
#include "ionskin/mechanics/elasticity/reference_element.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace ionskin::mechanics {

/// Faces of the box: twice the number of the axis that they are normal to, plus 1 at its end.
enum class Face { x_min = 0, x_max = 1, y_min = 2, y_max = 3, base = 4, top = 5 };

/// Displacement components held at zero on one face.
struct FixedFace {
  std::string name;
  Face face = Face::base;
  std::array<bool, 3> component{};
};

/// Bonded base; symmetry planes for half models and symmetric sides.
std::vector<FixedFace> skin_boundary(const Skin& skin, bool half_model);

/// Triquadratic displacement space on the fixed topology of a tensor-product mesh: numbering of
/// nodes and unknowns, sparsity. Independent of the positions of the mesh lines.
class ElasticSpace {
public:
  /// What is built beside the numbering.
  enum class Structure { none, stiffness };
  /// @param lines any lines of this topology
  /// @param structure none for a space that no stiffness matrix is assembled on: it takes memory
  ElasticSpace(const mesh::MeshLines& lines, const std::vector<FixedFace>& fixed,
               Structure structure = Structure::stiffness);

  /// Elements along x, y, z; elements are numbered x fastest.
  const std::array<std::size_t, 3>& elements() const { return elements_; }
  std::size_t element_count() const { return nodes_of_element_.size(); }
  const std::array<int, element_nodes>& nodes(std::size_t element) const {
    return nodes_of_element_[element];
  }
  std::size_t node_count() const { return unknown_.size(); }
  /// Node at a position of the lattice of vertices and mid-side points, 2 elements + 1 along each
  /// axis; nodes are numbered x fastest.
  int node_at(std::size_t i, std::size_t j, std::size_t k) const;
  /// Unknown of each displacement component of a node; -1 where it is held.
  const std::array<int, 3>& unknown(int node) const { return unknown_[node]; }
  bool on_base(int node) const { return on_base_[node]; }
  /// True when only the base holds this component, so that its reaction balances the loads.
  bool held_by_base_alone(int component) const { return held_by_base_alone_[component]; }
  int unknowns() const { return pattern_.size; }

  /// Lower triangle of the stiffness matrix; a node's unknowns are consecutive.
  const linear_algebra::SymmetricPattern& pattern() const { return pattern_; }
  /// Where, in a column of one node of an element, the entries of a node of larger number start:
  /// counted from the end of the column node's own entries.
  int row_offset(std::size_t element, int local_row, int local_column) const {
    return row_offset_[element * element_nodes * element_nodes +
                       static_cast<std::size_t>(local_row * element_nodes + local_column)];
  }

  /// Elimination order of the unknowns with those of `trailing_nodes` last, in the order given.
  std::vector<int> elimination_order(const std::vector<int>& trailing_nodes) const;
  /// Unknowns of nodes in the order given, held ones left out.
  std::vector<int> unknowns_of(const std::vector<int>& nodes) const;

private:
  bool held(int node) const { return unknown_[node] == std::array<int, 3>{-1, -1, -1}; }
  std::vector<int> nodes_on(Face face) const;
  void number_nodes();
  void hold(const FixedFace& face);
  /// Couplings between nodes that are not wholly held; held nodes stay as isolated entries.
  void build_node_graph();
  void number_unknowns();
  void build_pattern();
  void build_offsets();

  std::array<std::size_t, 3> elements_, lattice_; ///< elements and nodes along x, y, z
  std::vector<std::array<int, element_nodes>> nodes_of_element_;
  std::vector<std::array<int, 3>> unknown_;
  std::vector<bool> on_base_;
  std::array<bool, 3> held_by_base_alone_{true, true, true};
  linear_algebra::SymmetricPattern node_graph_; ///< of all nodes, lower triangle
  linear_algebra::SymmetricPattern pattern_;
  std::vector<int> row_offset_;
};

} // namespace ionskin::mechanics
