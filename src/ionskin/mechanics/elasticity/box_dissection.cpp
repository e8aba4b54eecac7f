// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/elasticity/box_dissection.hpp"

#include <optional>
#include <utility>

namespace ionskin::mechanics {
namespace {

/// Element lines that bound a part of the box, below and above, along each axis.
using Box = std::array<std::array<std::size_t, 2>, 3>;
/// Places of the lattice from the first to before the last, along each axis.
using NodeBox = std::array<std::array<std::size_t, 2>, 3>;

double count(const NodeBox& nodes) {
  double product = 1;
  for (const auto& [first, last] : nodes) {
    product *= static_cast<double>(last - first);
  }
  return product;
}

/// Of the Cholesky factorisation of a dense front by its pivots, which change a boundary.
double operations_of_front(double pivots, double boundary) {
  return pivots * (pivots * (pivots / 3 + boundary) + boundary * boundary);
}

class Dissection {
public:
  Dissection(const std::array<std::size_t, 3>& elements,
             const std::array<std::array<BoxFace, 2>, 3>& faces)
      : elements_(elements), faces_(faces),
        known_(sides * elements[0] * elements[1] * elements[2], -1.0) {
    append({{{0, elements[0]}, {0, elements[1]}, {0, elements[2]}}});
  }
  std::vector<int> take_order() { return std::move(order_); }

private:
  static constexpr std::size_t sides = 64; ///< of a box, each its own face or the whole's

  struct Cut {
    std::size_t axis = 0, line = 0;
    Box below(Box box) const {
      box[axis][1] = line;
      return box;
    }
    Box above(Box box) const {
      box[axis][0] = line;
      return box;
    }
  };
  struct Best {
    double operations = 0;
    std::optional<Cut> cut; ///< none where the box is best taken as it is
  };

  BoxFace face(const Box& box, std::size_t axis, std::size_t side) const {
    const bool whole = box[axis][side] == (side == 0 ? 0 : elements_[axis]);
    return whole ? faces_[axis][side] : BoxFace::later;
  }

  NodeBox nodes_of(const Box& box) const {
    NodeBox nodes{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      nodes[axis] = {2 * box[axis][0] + (face(box, axis, 0) == BoxFace::open ? 0 : 1),
                     2 * box[axis][1] + (face(box, axis, 1) == BoxFace::open ? 1 : 0)};
    }
    return nodes;
  }

  /// Nodes beside a box that are eliminated after it.
  double boundary_of(const Box& box, NodeBox nodes) const {
    const double inside = count(nodes);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      nodes[axis][0] -= face(box, axis, 0) == BoxFace::later ? 1 : 0;
      nodes[axis][1] += face(box, axis, 1) == BoxFace::later ? 1 : 0;
    }
    return count(nodes) - inside;
  }

  /// Those of boxes of one size with the same faces are the same.
  double& known(const Box& box) {
    std::size_t at = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      at = at * elements_[axis] + box[axis][1] - box[axis][0] - 1;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      at = 4 * at + (box[axis][0] > 0 ? 1 : 0) + (box[axis][1] < elements_[axis] ? 2 : 0);
    }
    return known_[at];
  }

  double operations(const Box& box) {
    if (known(box) < 0) {
      known(box) = best(box).operations;
    }
    return known(box);
  }

  Best best(const Box& box) {
    const NodeBox nodes = nodes_of(box);
    const double inside = count(nodes), boundary = boundary_of(box, nodes);
    Best result{operations_of_front(inside, boundary), {}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double plane = inside / static_cast<double>(nodes[axis][1] - nodes[axis][0]),
                   own = operations_of_front(plane, boundary);
      for (std::size_t line = box[axis][0] + 1; line < box[axis][1] && own < result.operations;
           ++line) {
        const Cut cut{axis, line};
        const double sum = own + operations(cut.below(box)) + operations(cut.above(box));
        if (sum < result.operations) {
          result = {sum, cut};
        }
      }
    }
    return result;
  }

  void append(const Box& box) {
    NodeBox nodes = nodes_of(box);
    if (const std::optional<Cut> cut = best(box).cut) {
      append(cut->below(box));
      append(cut->above(box));
      nodes[cut->axis] = {2 * cut->line, 2 * cut->line + 1};
    }
    for (std::size_t k = nodes[2][0]; k < nodes[2][1]; ++k) {
      for (std::size_t j = nodes[1][0]; j < nodes[1][1]; ++j) {
        for (std::size_t i = nodes[0][0]; i < nodes[0][1]; ++i) {
          order_.push_back(
              static_cast<int>(i + (2 * elements_[0] + 1) * (j + (2 * elements_[1] + 1) * k)));
        }
      }
    }
  }

  std::array<std::size_t, 3> elements_;
  std::array<std::array<BoxFace, 2>, 3> faces_;
  std::vector<double> known_;
  std::vector<int> order_;
};

} // namespace

std::vector<int> dissection_order(const std::array<std::size_t, 3>& elements,
                                  const std::array<std::array<BoxFace, 2>, 3>& faces) {
  return Dissection(elements, faces).take_order();
}

} // namespace ionskin::mechanics
