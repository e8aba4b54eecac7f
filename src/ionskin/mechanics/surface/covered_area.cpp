// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/covered_area.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace ionskin::mechanics {
namespace {

constexpr std::uintmax_t most_iterations = 60;
/// Tolerance of the border's position, over its farthest possible distance [1].
constexpr double border_tolerance = 1e-14;

/// Mean of sqrt(border - x) over an interval, times 3/2; the interval may reach beyond the border.
double mean_root(double from, double to, double border) {
  const auto power = [&](double x) {
    const double distance = std::max(0.0, border - x);
    return distance * std::sqrt(distance);
  };
  return (power(from) - power(to)) / (to - from);
}

/// Position of the border at which a field like sqrt(border - x) ends, from its means over its last
/// positive cell, which begins at 0, and over the cell before it.
/// @param width of the last positive cell
/// @param width_before of the cell before it
/// @param width_beyond of the open cell behind it, of which at most half is covered
/// @param ratio mean over the last positive cell, over the mean over the cell before it
double border_of(double width, double width_before, double width_beyond, double ratio) {
  const auto excess = [&](double border) {
    return mean_root(0, width, border) / mean_root(-width_before, 0, border) - ratio;
  };
  const double farthest = width + 0.5 * width_beyond, above = excess(farthest);
  if (!(above > 0)) {
    return farthest;
  }
  const auto close = [&](double low, double high) {
    return high - low <= border_tolerance * farthest;
  };
  std::uintmax_t iterations = most_iterations;
  const auto [low, high] =
      boost::math::tools::toms748_solve(excess, 0.0, farthest, -ratio, above, close, iterations);
  return 0.5 * (low + high);
}

/// Field on contact cells whose square falls linearly to a border.
class CellField {
public:
  CellField(const CellGrid& cells, std::span<const double> field)
      : cells_(cells), field_(field), count_{cells.lines_x.size() - 1, cells.lines_y.size() - 1} {}

  /// Area within the border: positive cells, corrected for where the border lies between grid
  /// lines.
  double area() const {
    double sum = 0;
    for (std::size_t cell = 0; cell < cells_.area.size(); ++cell) {
      if (field_[cell] <= 0) {
        continue;
      }
      sum += cells_.area[cell];
      for (std::size_t d = 0; d < 2; ++d) {
        for (const bool upwards : {false, true}) {
          sum += beyond_face(cell, d, upwards);
        }
      }
    }
    return sum;
  }

  /// Area of the cells at the border, on its inner side (`positive`) or on its outer side: cells
  /// with a neighbour on the other side.
  double area_at_border(bool positive) const {
    double sum = 0;
    for (std::size_t cell = 0; cell < cells_.area.size(); ++cell) {
      if ((field_[cell] > 0) == positive && is_at_border(cell)) {
        sum += cells_.area[cell];
      }
    }
    return sum;
  }

private:
  bool is_at_border(std::size_t cell) const {
    for (std::size_t d = 0; d < 2; ++d) {
      for (const bool upwards : {false, true}) {
        if (has_neighbour(cell, d, upwards) &&
            (field_[neighbour(cell, d, upwards)] > 0) != (field_[cell] > 0)) {
          return true;
        }
      }
    }
    return false;
  }
  std::size_t stride(std::size_t d) const { return d == 0 ? 1 : count_[0]; }
  std::size_t place(std::size_t cell, std::size_t d) const {
    return d == 0 ? cell % count_[0] : cell / count_[0];
  }
  bool has_neighbour(std::size_t cell, std::size_t d, bool upwards) const {
    return upwards ? place(cell, d) + 1 < count_[d] : place(cell, d) > 0;
  }
  std::size_t neighbour(std::size_t cell, std::size_t d, bool upwards) const {
    return upwards ? cell + stride(d) : cell - stride(d);
  }
  double width(std::size_t cell, std::size_t d) const {
    const std::span<const double> lines = d == 0 ? cells_.lines_x : cells_.lines_y;
    return lines[place(cell, d) + 1] - lines[place(cell, d)];
  }
  double square(std::size_t cell) const { return field_[cell] * field_[cell]; }

  /// Slope of the square of the field along direction d.
  double slope(std::size_t cell, std::size_t d) const {
    double rise = 0, distance = 0;
    for (const bool upwards : {false, true}) {
      if (has_neighbour(cell, d, upwards)) {
        const std::size_t next = neighbour(cell, d, upwards);
        rise += (upwards ? 1 : -1) * (square(next) - square(cell));
        distance += (width(cell, d) + width(next, d)) / 2;
      }
    }
    return distance > 0 ? rise / distance : 0.0;
  }

  /// Area between the border and the face of a positive cell towards an open cell, negative when
  /// the border lies within the positive cell. An oblique border is seen along both directions;
  /// each counts with its share of the border's normal.
  double beyond_face(std::size_t cell, std::size_t d, bool upwards) const {
    if (!has_neighbour(cell, d, upwards) || !has_neighbour(cell, d, !upwards) ||
        field_[neighbour(cell, d, upwards)] > 0) {
      return 0;
    }
    const std::size_t before = neighbour(cell, d, !upwards);
    if (field_[before] <= 0) {
      return 0;
    }
    const double along = slope(before, d), across = slope(before, 1 - d);
    const double steepness = along * along + across * across;
    const double weight = steepness > 0 ? along * along / steepness : 0.0;
    const double width_beyond = width(neighbour(cell, d, upwards), d);
    const double border =
        border_of(width(cell, d), width(before, d), width_beyond, field_[cell] / field_[before]);
    const double beyond = border - width(cell, d);
    return weight * beyond * width(cell, 1 - d);
  }

  CellGrid cells_;
  std::span<const double> field_;
  std::array<std::size_t, 2> count_;
};

} // namespace

double covered_area(const CellGrid& cells, std::span<const double> field) noexcept {
  return CellField(cells, field).area();
}

double border_area(const CellGrid& cells, std::span<const double> field) noexcept {
  const CellField cell_field(cells, field);
  return std::max(cell_field.area_at_border(true), cell_field.area_at_border(false)) / 2;
}

std::vector<double> normal_pressure(const CellGrid& cells, const std::vector<double>& force) {
  std::vector<double> pressure(cells.area.size());
  for (std::size_t cell = 0; cell < cells.area.size(); ++cell) {
    pressure[cell] = std::max(0.0, force[3 * cell]) / cells.area[cell];
  }
  return pressure;
}

double contact_area(const CellGrid& cells, const std::vector<double>& force) {
  return covered_area(cells, normal_pressure(cells, force));
}

} // namespace ionskin::mechanics
