// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/reduction/place_symmetry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace ionskin::live {
namespace {

/// Difference of mirror images that counts as 0, over the largest length [1].
constexpr double symmetric = 1e-9;

/// Coordinates measured from a middle [m].
std::vector<double> about(double middle, std::vector<double> lines) {
  for (double& line : lines) {
    line -= middle;
  }
  return lines;
}

/// True if the lines of a grid are symmetric about 0.
bool is_mirrored(const std::vector<double>& lines) {
  const double most = std::max(std::abs(lines.front()), std::abs(lines.back()));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (std::abs(lines[i] + lines[lines.size() - 1 - i]) > symmetric * most) {
      return false;
    }
  }
  return true;
}

} // namespace

bool are_mirrored(const PlaceNodes& places, const SkinData& data) {
  return is_mirrored(about(data.length / 2, places.x)) &&
         is_mirrored(about(data.width / 2, places.y));
}

Reflections reflections_of(const mechanics::SkinModel& model) {
  const std::array<std::size_t, 3> size{model.cells.columns(), model.cells.rows(), 1};
  const double deepest = *std::ranges::max_element(model.gap);
  std::array<bool, 2> along{is_mirrored(model.cells.lines_x),
                            !model.mesh.half_model() && is_mirrored(model.cells.lines_y)};
  for (std::size_t d = 0; d < 2; ++d) {
    const Reflections alone(d == 0, d == 1);
    for (std::size_t cell = 0; along[d] && cell < model.gap.size(); ++cell) {
      along[d] =
          std::abs(model.gap[cell] - model.gap[alone.image(1, cell, size)]) <= symmetric * deepest;
    }
  }
  return {along[0], along[1]};
}

MotionBox mirrored_box(const MotionBox& box, const SkinData& data) {
  const std::array<double, 2> extent{data.length, data.width};
  MotionBox both = box;
  for (std::size_t d = 0; d < 2; ++d) {
    both.low[d] = std::min(box.low[d], extent[d] - box.high[d]);
    both.high[d] = extent[d] - both.low[d];
  }
  return both;
}

} // namespace ionskin::live
