// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/slider/fine_features.hpp"

#include "ionskin/base/percent.hpp"
#include "ionskin/mechanics/slider/slider_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ionskin::mechanics {
namespace {

constexpr std::size_t samples_along_cell = 11; ///< samples of a cell along x, and along y
/// Rms departure from a plane above which a warning is given, over the deepest indentation [1].
constexpr double departure_limit = 0.1;

/// Contact cell in the plan of the slider.
struct PlanCell {
  double x = 0, y = 0, length = 0, width = 0; ///< corner and sizes [m]
};

/// Rms departure of the underside from a plane, from samples in a cell [m]; 0 where the cell does
/// not reach within `depth` of the lowest point, or lies partly beyond the plan.
double departure_in(const Underside& underside, const PlanCell& cell, double depth) {
  // Positions from the cell's middle, over its size: x, y and 1 are orthogonal in the samples.
  const auto place = [](std::size_t i) {
    return (static_cast<double>(i) + 0.5) / static_cast<double>(samples_along_cell) - 0.5;
  };
  double sum = 0, square = 0, with_x = 0, with_y = 0, places = 0, least = depth;
  for (std::size_t j = 0; j < samples_along_cell; ++j) {
    for (std::size_t i = 0; i < samples_along_cell; ++i) {
      const double along_x = place(i), along_y = place(j),
                   gap = underside.gap(cell.x + (along_x + 0.5) * cell.length,
                                       cell.y + (along_y + 0.5) * cell.width);
      if (gap >= shapes::unreachable_gap) {
        return 0;
      }
      least = std::min(least, gap);
      sum += gap;
      square += gap * gap;
      with_x += along_x * gap;
      with_y += along_y * gap;
      places += along_x * along_x;
    }
  }
  constexpr auto count = static_cast<double>(samples_along_cell * samples_along_cell);
  const double left = square - sum * sum / count - (with_x * with_x + with_y * with_y) / places;
  return least < depth ? std::sqrt(std::max(0.0, left) / count) : 0;
}

} // namespace

FineFeatures fine_features(const Slider& slider, const std::vector<double>& lines_x,
                           const std::vector<double>& lines_y, double depth) {
  const Underside underside(slider, slider.pose);
  FineFeatures worst;
  for (std::size_t j = 1; j < lines_y.size(); ++j) {
    for (std::size_t i = 1; i < lines_x.size(); ++i) {
      const PlanCell cell{lines_x[i - 1], lines_y[j - 1], lines_x[i] - lines_x[i - 1],
                          lines_y[j] - lines_y[j - 1]};
      const double own = departure_in(underside, cell, depth);
      if (own > worst.departure) {
        worst = {own, {cell.length, cell.width}};
      }
    }
  }
  return worst;
}

std::optional<std::string> warn_of_fine_features(const Slider& slider,
                                                 const std::vector<double>& lines_x,
                                                 const std::vector<double>& lines_y, double depth) {
  if (slider.profile_heights.height.empty() || depth <= 0) {
    return std::nullopt;
  }
  const FineFeatures worst = fine_features(slider, lines_x, lines_y, depth);
  if (worst.departure <= departure_limit * depth) {
    return std::nullopt;
  }
  return fmt::format(
      "The height map has features finer than the contact's cells, of {:.3g} um x {:.3g} um: "
      "within "
      "one it departs from a plane by {:.3g} um rms, {} of the deepest indentation, and the "
      "contact feels its mean over the cell alone. Raise numerics.mesh_refinement or choose a "
      "finer numerics.preset until this is gone, or smooth the map over a cell if so fine a "
      "texture is not meant.",
      1e6 * worst.cell_size[0], 1e6 * worst.cell_size[1], 1e6 * worst.departure,
      base::percent(worst.departure / depth));
}

} // namespace ionskin::mechanics
