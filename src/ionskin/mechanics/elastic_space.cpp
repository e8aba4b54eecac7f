// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/elastic_space.hpp"

#include "ionskin/linear_algebra/fill_ordering.hpp"

#include <deal.II/base/index_set.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>

namespace ionskin::mechanics {
namespace {

std::vector<double> sizes(const std::vector<double>& line) {
  std::vector<double> result;
  for (std::size_t i = 1; i < line.size(); ++i) {
    result.push_back(line[i] - line[i - 1]);
  }
  return result;
}

void make_box(dealii::Triangulation<3>& triangulation, const mesh::MeshLines& lines) {
  dealii::GridGenerator::subdivided_hyper_rectangle(
      triangulation, {sizes(lines.x), sizes(lines.y), sizes(lines.z)},
      dealii::Point<3>(lines.x.front(), lines.y.front(), lines.z.front()),
      dealii::Point<3>(lines.x.back(), lines.y.back(), lines.z.back()), true);
}

/// Couplings between nodes that are not wholly held; held nodes stay as isolated entries.
linear_algebra::SymmetricPattern lower_triangle(const dealii::DynamicSparsityPattern& pattern,
                                                const std::vector<std::array<int, 3>>& unknown) {
  const auto held = [&](int node) { return unknown[node] == std::array<int, 3>{-1, -1, -1}; };
  const int size = static_cast<int>(pattern.n_rows());
  linear_algebra::SymmetricPattern result{size, {0}, {}};
  for (int j = 0; j < size; ++j) {
    for (auto entry = pattern.begin(j); entry != pattern.end(j); ++entry) {
      const int i = static_cast<int>(entry->column());
      if (i == j || (i > j && !held(i) && !held(j))) {
        result.row.push_back(i);
      }
    }
    result.column_start.push_back(static_cast<int>(result.row.size()));
  }
  return result;
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

ElasticSpace::ElasticSpace(const mesh::MeshLines& lines, const std::vector<FixedFace>& fixed)
    : elements_{lines.x.size() - 1, lines.y.size() - 1, lines.z.size() - 1} {
  dealii::Triangulation<3> triangulation;
  make_box(triangulation, lines);
  const dealii::FE_Q<3> shape(2);
  dealii::DoFHandler<3> handler(triangulation);
  handler.distribute_dofs(shape);

  const std::vector<unsigned int> hierarchic =
      dealii::FETools::lexicographic_to_hierarchic_numbering<3>(2);
  std::vector<dealii::types::global_dof_index> cell_nodes(element_nodes);
  for (const auto& cell : handler.active_cell_iterators()) {
    cell->get_dof_indices(cell_nodes);
    std::array<int, element_nodes>& nodes = nodes_of_element_.emplace_back();
    for (int i = 0; i < element_nodes; ++i) {
      nodes[i] = static_cast<int>(cell_nodes[hierarchic[i]]);
    }
  }

  unknown_.assign(handler.n_dofs(), {0, 0, 0});
  on_base_.assign(handler.n_dofs(), false);
  for (const FixedFace& face : fixed) {
    const dealii::IndexSet nodes = dealii::DoFTools::extract_boundary_dofs(
        handler, dealii::ComponentMask(), {static_cast<dealii::types::boundary_id>(face.face)});
    for (const auto node : nodes) {
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
  dealii::DynamicSparsityPattern graph(handler.n_dofs());
  dealii::DoFTools::make_sparsity_pattern(handler, graph);
  node_graph_ = lower_triangle(graph, unknown_);
  number_unknowns();
  build_pattern();
  build_offsets();
}

int ElasticSpace::node_at(std::size_t i, std::size_t j, std::size_t k) const {
  const std::array<std::size_t, 3> at{i, j, k};
  std::array<std::size_t, 3> element{}, local{};
  for (int d = 0; d < 3; ++d) {
    element[d] = std::min(at[d] / 2, elements_[d] - 1);
    local[d] = at[d] - 2 * element[d];
  }
  const std::size_t e = element[0] + elements_[0] * (element[1] + elements_[1] * element[2]);
  return nodes_of_element_[e][local[0] + 3 * (local[1] + 3 * local[2])];
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
  return unknowns_of(linear_algebra::trailing_ordering(node_graph_, trailing_nodes));
}

} // namespace ionskin::mechanics
