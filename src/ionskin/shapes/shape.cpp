// SPDX-License-Identifier: Apache-2.0
#include "ionskin/shapes/shape.hpp"

#include "ionskin/laws/named_row.hpp"
#include "ionskin/shapes/cylinder.hpp"
#include "ionskin/shapes/flat.hpp"
#include "ionskin/shapes/profile.hpp"
#include "ionskin/shapes/sphere.hpp"

#include <algorithm>
#include <limits>

namespace ionskin::shapes {
namespace {

template <class Kind> std::unique_ptr<const Shape> shape_with(const laws::LawValues& values) {
  Kind result;
  for (const laws::OwnParameter<Kind>& own : Kind::parameters()) {
    if (const auto found = values.find(own.declared.name); found != values.end()) {
      result.*own.member = found->second;
    }
  }
  return std::make_unique<const Kind>(result);
}

template <class Kind> ShapeRow row(std::string_view name) {
  return {.name = name,
          .meaning = Kind::meaning,
          .takes_heights = Kind::takes_heights,
          .has_whole_plan = Kind::has_whole_plan,
          .parameters = laws::declared_parameters<Kind>(),
          .with = shape_with<Kind>};
}

/// Intervals of the search grid of `Shape::lowest_on_slope` along x and y, and number of finer
/// grids around the best point so far.
constexpr int grid_intervals = 64, finer_grids = 6;

} // namespace

double Shape::lowest_on_slope(const Plan& plan, const std::array<double, 2>& slope) const {
  std::array<double, 2> low{-plan.size[0] / 2, -plan.size[1] / 2},
      high{plan.size[0] / 2, plan.size[1] / 2};
  double least = std::numeric_limits<double>::infinity();
  std::array<double, 2> best = low; // kept if a finer grid has no better point
  for (int grid = 0; grid <= finer_grids; ++grid) {
    const std::array<double, 2> step{(high[0] - low[0]) / grid_intervals,
                                     (high[1] - low[1]) / grid_intervals};
    for (int j = 0; j <= grid_intervals; ++j) {
      for (int i = 0; i <= grid_intervals; ++i) {
        const double x = low[0] + i * step[0], y = low[1] + j * step[1];
        const double at = height(plan, x, y) + slope[0] * x + slope[1] * y;
        if (at < least) {
          least = at;
          best = {x, y};
        }
      }
    }
    for (std::size_t d = 0; d < 2; ++d) {
      low[d] = std::max(best[d] - 2 * step[d], -plan.size[d] / 2);
      high[d] = std::min(best[d] + 2 * step[d], plan.size[d] / 2);
    }
  }
  return least;
}

std::span<const ShapeRow> shapes() {
  static const std::array rows{
      row<Flat>("flat"),
      row<Cylinder>("cylinder"),
      row<Sphere>("sphere"),
      row<Profile>("profile"),
  };
  return rows;
}

const ShapeRow& shape_row(std::string_view name) {
  return laws::named_row(shapes(), name, "slider shape");
}

std::unique_ptr<const Shape> shape(std::string_view name, const laws::LawValues& values) {
  return shape_row(name).with(values);
}

} // namespace ionskin::shapes
