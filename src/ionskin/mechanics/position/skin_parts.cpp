// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/skin_parts.hpp"

#include "ionskin/mesh/grading.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <algorithm>
#include <utility>

namespace ionskin::mechanics {
namespace {

std::vector<double>& along(mesh::MeshLines& lines, std::size_t axis) {
  return axis == 0 ? lines.x : lines.y;
}

mesh::MeshLines slab(mesh::MeshLines lines, std::size_t axis, std::size_t first, std::size_t last) {
  std::vector<double>& line = along(lines, axis);
  line.assign(line.begin() + static_cast<std::ptrdiff_t>(first),
              line.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  return lines;
}

/// Faces that hold a slab of the skin between two element lines of `count`.
std::vector<FixedFace> faces_of_slab(const std::vector<FixedFace>& fixed, std::size_t axis,
                                     std::size_t first, std::size_t last, std::size_t count) {
  std::vector<FixedFace> result;
  for (const FixedFace& face : fixed) {
    const auto side = static_cast<std::size_t>(face.face);
    if (side / 2 != axis || (side % 2 == 0 ? first == 0 : last == count)) {
      result.push_back(face);
    }
  }
  return result;
}

/// Nodes at a place of the lattice along an axis, in the order of the skin's.
std::vector<int> plane(const ElasticSpace& space, std::size_t axis, std::size_t place) {
  std::vector<int> nodes;
  const auto& elements = space.elements();
  for (std::size_t k = 0; k <= 2 * elements[2]; ++k) {
    for (std::size_t across = 0; across <= 2 * elements[1 - axis]; ++across) {
      nodes.push_back(axis == 0 ? space.node_at(place, across, k)
                                : space.node_at(across, place, k));
    }
  }
  return nodes;
}

/// The node of the skin at a node of a part.
int whole_node(const ElasticSpace& whole, const PlacedPart& placed, std::size_t axis, int node) {
  const auto& elements = placed.part->space.elements();
  const std::size_t nx = 2 * elements[0] + 1, ny = 2 * elements[1] + 1;
  const auto index = static_cast<std::size_t>(node);
  std::array<std::size_t, 3> at{index % nx, index / nx % ny, index / (nx * ny)};
  at[axis] = placed.mirrored ? 2 * placed.last - at[axis] : 2 * placed.first + at[axis];
  return whole.node_at(at[0], at[1], at[2]);
}

void number_in_whole(const ElasticSpace& whole, std::size_t axis, PlacedPart& placed) {
  const ElasticSpace& space = placed.part->space;
  std::vector<int> whole_unknown(static_cast<std::size_t>(space.unknowns()));
  std::vector<double> sign(whole_unknown.size(), 1.0);
  for (std::size_t node = 0; node < space.node_count(); ++node) {
    const int in_whole = whole_node(whole, placed, axis, static_cast<int>(node));
    for (std::size_t c = 0; c < 3; ++c) {
      const int unknown = space.unknown(static_cast<int>(node))[c];
      if (unknown >= 0) {
        whole_unknown[unknown] = whole.unknown(in_whole)[c];
        sign[unknown] = placed.mirrored && c == axis ? -1 : 1;
      }
    }
  }
  for (const int unknown : placed.part->symbolic.order()) {
    placed.whole_unknown.push_back(whole_unknown[unknown]);
    placed.sign.push_back(sign[unknown]);
  }
}

std::vector<int> joined(std::vector<int> first, const std::vector<int>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

linear_algebra::SymbolicCholesky analysed(const ElasticSpace& space,
                                          const std::vector<int>& trailing_nodes) {
  return {space.pattern(), space.elimination_order(trailing_nodes),
          static_cast<int>(space.unknowns_of(trailing_nodes).size())};
}

} // namespace

SkinPart::SkinPart(ElasticSpace part_space, const std::vector<int>& interface_nodes)
    : space(std::move(part_space)), symbolic(analysed(space, interface_nodes)),
      interface(symbolic.trailing()) {}

SkinParts::SkinParts(const ElasticSpace& whole, const mesh::MeshLines& any_lines,
                     const std::vector<FixedFace>& fixed, const ContactCells& cells,
                     const SkinCut& skin_cut, int threads)
    : cut(skin_cut) {
  const std::size_t axis = cut.axis, count = whole.elements()[axis];
  // A part meets others where it does not end with the skin.
  const auto part_of = [&](std::size_t first, std::size_t last) {
    ElasticSpace space(slab(any_lines, axis, first, last),
                       faces_of_slab(fixed, axis, first, last, count));
    std::vector<int> nodes;
    if (first > 0) {
      nodes = plane(space, axis, 0);
    }
    if (last < count) {
      nodes = joined(std::move(nodes), plane(space, axis, 2 * (last - first)));
    }
    return std::make_shared<const SkinPart>(std::move(space), nodes);
  };
  inner.first = cut.footprint[0];
  inner.last = cut.footprint[1];
  for (const bool behind : {false, true}) {
    const std::size_t first = behind ? inner.last : 0, last = behind ? count : inner.first;
    if (first < last) {
      PlacedPart& placed = outer.emplace_back();
      placed.first = first;
      placed.last = last;
      placed.mirrored = behind;
    }
  }
  const bool alike = outer.size() == 2 && inner.first == count - inner.last;
  parallel::run_tasks(1 + (alike ? 1 : outer.size()), threads, [&](std::size_t i) {
    PlacedPart& placed = i == 0 ? inner : outer[i - 1];
    placed.part =
        i == 0 ? part_of(inner.first, inner.last) : part_of(0, placed.last - placed.first);
  });
  if (alike) {
    outer.back().part = outer.front().part;
  }
  for (PlacedPart& placed : outer) {
    placed.first_interface = interface;
    interface += placed.part->interface;
    number_in_whole(whole, axis, placed);
  }
  number_in_whole(whole, axis, inner);

  unknown.resize(static_cast<std::size_t>(whole.unknowns()));
  const auto find_unknowns = [&](const PlacedPart& placed, int part) {
    for (std::size_t k = 0; k < placed.whole_unknown.size(); ++k) {
      unknown[placed.whole_unknown[k]] = {part, static_cast<int>(k), placed.sign[k]};
    }
  };
  find_unknowns(inner, 0);
  for (std::size_t p = 0; p < outer.size(); ++p) {
    find_unknowns(outer[p], static_cast<int>(p) + 1);
  }

  std::vector<int> inner_place(static_cast<std::size_t>(whole.unknowns()), -1);
  for (std::size_t k = 0; k < inner.whole_unknown.size(); ++k) {
    inner_place[inner.whole_unknown[k]] = static_cast<int>(k);
  }
  for (const int loaded : whole.unknowns_of(cells.nodes)) {
    load_place.push_back(inner_place[loaded]);
  }
}

mesh::MeshLines SkinParts::inner_lines(const ContactCells& cells,
                                       const mesh::MeshLines& whole) const {
  mesh::MeshLines lines = whole;
  along(lines, cut.axis) = cut.axis == 0 ? cells.lines_x : cells.lines_y;
  return lines;
}

mesh::MeshLines SkinParts::outer_lines(const PlacedPart& placed,
                                       const mesh::MeshLines& whole) const {
  mesh::MeshLines lines = slab(whole, cut.axis, placed.first, placed.last);
  if (placed.mirrored) {
    std::vector<double>& line = along(lines, cut.axis);
    const double start = line.front();
    for (double& value : line) {
      value -= start;
    }
    line = mesh::reversed(line);
  }
  return lines;
}

} // namespace ionskin::mechanics
