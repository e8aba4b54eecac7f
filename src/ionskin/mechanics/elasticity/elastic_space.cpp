// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/elasticity/elastic_space.hpp"

#include "ionskin/linear_algebra/postorder.hpp"
#include "ionskin/mechanics/elasticity/box_dissection.hpp"

#include <algorithm>
#include <numeric>

namespace ionskin::mechanics {
namespace {

/// First and last node of a lattice line that share an element with its node `i`: vertices, at even
/// places, belong to two elements, mid-side nodes to one.
std::array<std::size_t, 2> neighbours(std::size_t i, std::size_t last) {
  const std::size_t reach = i % 2 == 0 ? 2 : 1;
  return {i < reach ? 0 : i - reach, std::min(i + reach, last)};
}

} // namespace

std::vector<FixedFace> skin_boundary(const Skin& skin, bool half_model) {
  std::vector<FixedFace> fixed{{"bonded base", Face::base, {true, true, true}}};
  const bool symmetric_sides = skin.sides == SideCondition::symmetry;
  if (symmetric_sides) {
    fixed.push_back({"symmetric side", Face::y_min, {false, true, false}});
  }
  if (half_model || symmetric_sides) {
    fixed.push_back(
        {half_model ? "symmetry plane" : "symmetric side", Face::y_max, {false, true, false}});
  }
  return fixed;
}

ElasticSpace::ElasticSpace(const mesh::MeshLines& lines, const std::vector<FixedFace>& fixed,
                           Structure structure)
    : elements_{lines.x.size() - 1, lines.y.size() - 1, lines.z.size() - 1},
      lattice_{2 * elements_[0] + 1, 2 * elements_[1] + 1, 2 * elements_[2] + 1} {
  number_nodes();
  for (const FixedFace& face : fixed) {
    hold(face);
  }
  number_unknowns();
  if (structure == Structure::stiffness) {
    build_node_graph();
    build_pattern();
    build_offsets();
  }
}

int ElasticSpace::node_at(std::size_t i, std::size_t j, std::size_t k) const {
  return static_cast<int>(i + lattice_[0] * (j + lattice_[1] * k));
}

void ElasticSpace::number_nodes() {
  const auto [nx, ny, nz] = elements_;
  nodes_of_element_.reserve(nx * ny * nz);
  for (std::size_t e = 0; e < nx * ny * nz; ++e) {
    const std::size_t i = e % nx, j = e / nx % ny, k = e / (nx * ny);
    std::array<int, element_nodes>& nodes = nodes_of_element_.emplace_back();
    for (std::size_t local = 0; local < nodes.size(); ++local) {
      nodes[local] = node_at(2 * i + local % 3, 2 * j + local / 3 % 3, 2 * k + local / 9);
    }
  }
  unknown_.assign(lattice_[0] * lattice_[1] * lattice_[2], {0, 0, 0});
  on_base_.assign(unknown_.size(), false);
}

std::vector<int> ElasticSpace::nodes_on(Face face) const {
  const auto side = static_cast<std::size_t>(face);
  std::array<std::size_t, 3> first{0, 0, 0}, last = lattice_;
  (side % 2 == 0 ? last : first)[side / 2] = side % 2 == 0 ? 1 : lattice_[side / 2] - 1;
  std::vector<int> nodes;
  for (std::size_t k = first[2]; k < last[2]; ++k) {
    for (std::size_t j = first[1]; j < last[1]; ++j) {
      for (std::size_t i = first[0]; i < last[0]; ++i) {
        nodes.push_back(node_at(i, j, k));
      }
    }
  }
  return nodes;
}

void ElasticSpace::hold(const FixedFace& face) {
  for (const int node : nodes_on(face.face)) {
    on_base_[node] = on_base_[node] || face.face == Face::base;
    for (int c = 0; c < 3; ++c) {
      unknown_[node][c] = face.component[c] ? -1 : unknown_[node][c];
    }
  }
  for (int c = 0; c < 3; ++c) {
    held_by_base_alone_[c] =
        held_by_base_alone_[c] && (face.face == Face::base || !face.component[c]);
  }
}

void ElasticSpace::build_node_graph() {
  node_graph_ = {static_cast<int>(unknown_.size()), {0}, {}};
  for (std::size_t k = 0; k < lattice_[2]; ++k) {
    const auto [first_k, last_k] = neighbours(k, lattice_[2] - 1);
    for (std::size_t j = 0; j < lattice_[1]; ++j) {
      const auto [first_j, last_j] = neighbours(j, lattice_[1] - 1);
      for (std::size_t i = 0; i < lattice_[0]; ++i) {
        const auto [first_i, last_i] = neighbours(i, lattice_[0] - 1);
        const int column = node_at(i, j, k);
        for (std::size_t c = first_k; c <= last_k; ++c) {
          for (std::size_t b = first_j; b <= last_j; ++b) {
            for (int row = node_at(first_i, b, c); row <= node_at(last_i, b, c); ++row) {
              if (row == column || (row > column && !held(row) && !held(column))) {
                node_graph_.row.push_back(row);
              }
            }
          }
        }
        node_graph_.column_start.push_back(static_cast<int>(node_graph_.row.size()));
      }
    }
  }
}

void ElasticSpace::number_unknowns() {
  int next = 0;
  for (std::array<int, 3>& unknown : unknown_) {
    for (int& index : unknown) {
      index = index < 0 ? -1 : next++;
    }
  }
  pattern_.size = next;
}

void ElasticSpace::build_pattern() {
  pattern_.column_start = {0};
  pattern_.column_start.reserve(static_cast<std::size_t>(pattern_.size) + 1);
  pattern_.row.reserve(9 * node_graph_.row.size());
  for (int node = 0; node < node_graph_.size; ++node) {
    for (int c = 0; c < 3; ++c) {
      if (unknown_[node][c] < 0) {
        continue;
      }
      for (int p = node_graph_.column_start[node]; p < node_graph_.column_start[node + 1]; ++p) {
        for (const int index : unknown_[node_graph_.row[p]]) {
          if (index >= unknown_[node][c]) {
            pattern_.row.push_back(index);
          }
        }
      }
      pattern_.column_start.push_back(static_cast<int>(pattern_.row.size()));
    }
  }
}

void ElasticSpace::build_offsets() {
  row_offset_.assign(nodes_of_element_.size() * element_nodes * element_nodes, 0);
  std::vector<int> free_components(unknown_.size());
  for (std::size_t node = 0; node < unknown_.size(); ++node) {
    free_components[node] = static_cast<int>(std::count_if(
        unknown_[node].begin(), unknown_[node].end(), [](int index) { return index >= 0; }));
  }
  // Offsets along one node column, valid while that column is current.
  std::vector<int> offset(unknown_.size());
  std::vector<std::vector<std::pair<std::size_t, int>>> places(unknown_.size());
  for (std::size_t e = 0; e < nodes_of_element_.size(); ++e) {
    for (int i = 0; i < element_nodes; ++i) {
      places[nodes_of_element_[e][i]].emplace_back(e, i);
    }
  }
  for (int node = 0; node < node_graph_.size; ++node) {
    int next = 0;
    for (int p = node_graph_.column_start[node]; p < node_graph_.column_start[node + 1]; ++p) {
      const int row = node_graph_.row[p];
      if (row > node) {
        offset[row] = next;
        next += free_components[row];
      }
    }
    for (const auto& [element, local] : places[node]) {
      for (int i = 0; i < element_nodes; ++i) {
        const int row = nodes_of_element_[element][i];
        if (row > node) {
          row_offset_[(element * element_nodes + i) * element_nodes + local] = offset[row];
        }
      }
    }
  }
}

std::vector<int> ElasticSpace::unknowns_of(const std::vector<int>& nodes) const {
  std::vector<int> result;
  for (const int node : nodes) {
    for (const int index : unknown_[node]) {
      if (index >= 0) {
        result.push_back(index);
      }
    }
  }
  return result;
}

std::vector<int> ElasticSpace::elimination_order(const std::vector<int>& trailing_nodes) const {
  std::vector<bool> listed(unknown_.size());
  for (const int node : trailing_nodes) {
    listed[node] = true;
  }
  std::array<std::array<BoxFace, 2>, 3> faces{};
  for (std::size_t side = 0; side < 6; ++side) {
    const std::vector<int> nodes = nodes_on(static_cast<Face>(side));
    const auto is_held = [&](int node) { return held(node); };
    const auto is_held_or_later = [&](int node) { return held(node) || listed[node]; };
    faces[side / 2][side % 2] = std::ranges::all_of(nodes, is_held)            ? BoxFace::held
                                : std::ranges::all_of(nodes, is_held_or_later) ? BoxFace::later
                                                                               : BoxFace::open;
  }
  std::vector<int> order, all(unknown_.size());
  std::iota(all.begin(), all.end(), 0);
  for (const std::vector<int>& nodes : {dissection_order(elements_, faces), all}) {
    for (const int node : nodes) { // the second time those that are held, which nothing couples to
      if (!listed[node]) {
        order.push_back(node);
        listed[node] = true;
      }
    }
  }
  order.insert(order.end(), trailing_nodes.begin(), trailing_nodes.end());
  return unknowns_of(
      linear_algebra::postordered(node_graph_, order, static_cast<int>(trailing_nodes.size())));
}

} // namespace ionskin::mechanics
