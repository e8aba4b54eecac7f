// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/grid/transport_grid.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::electrochemistry {
namespace {

/// Least number of columns along a taxel with a circuit of its own.
constexpr double columns_per_taxel = 2.0;

constexpr std::size_t fewest_x = 24, most_x = 150, fewest_y = 8, most_y = 40;

/// Thickness of the part at each wall that grows with `layer_growth` [Debye lengths].
constexpr double layer_thickness = 1.0;

/// Number of terms of the series first, first q, first q^2, ... whose sum reaches `sum`.
std::size_t terms_to_reach(double sum, double first, double ratio) {
  return static_cast<std::size_t>(
      std::ceil(std::log1p(sum / first * (ratio - 1.0)) / std::log(ratio)));
}

double geometric_sum(double first, double ratio, std::size_t count) {
  double sum = 0.0;
  for (double term = first; count > 0; --count, term *= ratio) {
    sum += term;
  }
  return sum;
}

/// Appends `count` spacings after `last`, in a constant ratio for which they add up to `sum`.
void append_fitted(std::vector<double>& spacings, double last, double sum, std::size_t count) {
  double low = 0.5, high = 4.0;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (geometric_sum(last * middle, middle, count) > sum ? high : low) = middle;
  }
  for (std::size_t i = 0; i < count; ++i) {
    last *= low;
    spacings.push_back(last);
  }
}

/// Spacings from a wall to the middle [Debye lengths].
std::vector<double> half_spacings(double half, const GridResolution& resolution) {
  const double first = resolution.wall_cell, layer = std::min(layer_thickness, 0.25 * half);
  std::vector<double> spacings;
  double reached = 0.0;
  for (double spacing = first; reached < layer; spacing *= resolution.layer_growth) {
    spacings.push_back(spacing);
    reached += spacing;
  }
  double growth = resolution.layer_growth;
  const auto accelerate = [&] {
    growth = std::min(1.0 + resolution.acceleration * (growth - 1.0), resolution.bulk_growth);
  };
  for (accelerate(); growth < resolution.bulk_growth && reached < 0.5 * half; accelerate()) {
    spacings.push_back(growth * spacings.back());
    reached += spacings.back();
  }
  const double rest = half - reached, last = spacings.back();
  append_fitted(spacings, last, rest, terms_to_reach(rest, last * growth, growth));
  return spacings;
}

/// True if the potential of the top face varies along an axis: a taxel with a circuit of its own
/// ends on the skin.
bool is_cut(const Readout& readout, std::size_t axis, double length) {
  bool cut = false;
  for (std::size_t i = 0; i < readout.taxels.size(); ++i) {
    const Taxel& taxel = readout.taxels[i];
    cut = cut || (readout.has_own_circuit(i) &&
                  taxel.upper[axis] - taxel.lower[axis] < (1.0 - 1e-9) * length);
  }
  return cut;
}

std::vector<double> uniform_edges(double length, std::size_t count) {
  std::vector<double> edges(count + 1);
  for (std::size_t i = 0; i <= count; ++i) {
    edges[i] = length * static_cast<double>(i) / static_cast<double>(count);
  }
  return edges;
}

} // namespace

GridResolution grid_resolution(Preset preset) {
  const auto preset_of = [](double refinement, double column_width) {
    GridResolution resolution = refined({0.06, 1.04, 1.2, 1.6, column_width}, refinement);
    resolution.column_width = column_width;
    return resolution;
  };
  switch (preset) {
  case Preset::coarse:
    return preset_of(0.6, 1.7);
  case Preset::standard:
    return preset_of(1.0, 1.0 / 0.9);
  case Preset::fine:
    return preset_of(2.8, 0.75);
  }
  throw InternalError("unknown preset");
}

GridResolution refined(const GridResolution& resolution, double refinement) {
  return {resolution.wall_cell / refinement, 1.0 + (resolution.layer_growth - 1.0) / refinement,
          std::pow(resolution.acceleration, 1.0 / refinement),
          1.0 + (resolution.bulk_growth - 1.0) / refinement, resolution.column_width / refinement};
}

std::vector<double> graded_nodes(double thickness, double debye_length,
                                 const GridResolution& resolution) {
  const double half = 0.5 * thickness / debye_length;
  if (half < 8.0 * resolution.wall_cell) {
    return uniform_edges(thickness, 16);
  }
  const std::vector<double> spacings = half_spacings(half, resolution);
  const std::size_t count = spacings.size();
  std::vector<double> nodes(2 * count + 1, 0.0);
  for (std::size_t i = 1; i < count; ++i) {
    nodes[i] = nodes[i - 1] + spacings[i - 1] * debye_length;
    nodes[2 * count - i] = thickness - nodes[i];
  }
  nodes[count] = 0.5 * thickness;
  nodes[2 * count] = thickness;
  return nodes;
}

std::size_t column_count(double length, double width, std::size_t fewest, std::size_t most) {
  const double count =
      std::clamp(length / width, static_cast<double>(fewest), static_cast<double>(most));
  return static_cast<std::size_t>(std::lround(count));
}

std::size_t aligned_column_count(std::size_t count, std::size_t step,
                                 const std::vector<double>& fractions) {
  constexpr double rounding = 1e-9;                   // of the length
  constexpr double most_exact = 2.0, most_near = 1.5; // times the columns
  const auto misfit = [&](std::size_t columns) {
    double worst = 0;
    for (const double fraction : fractions) {
      const double at = fraction * static_cast<double>(columns);
      worst = std::max(worst, std::abs(at - std::round(at)) / static_cast<double>(columns));
    }
    return worst;
  };
  std::size_t nearest = count;
  for (std::size_t columns = count;
       static_cast<double>(columns) <= most_exact * static_cast<double>(count); columns += step) {
    const double worst = misfit(columns);
    if (worst <= rounding) {
      return columns;
    }
    if (worst < misfit(nearest) &&
        static_cast<double>(columns) <= most_near * static_cast<double>(count)) {
      nearest = columns;
    }
  }
  return misfit(nearest) < 0.5 * misfit(count) ? nearest : count;
}

TransportGrid make_transport_grid(const Case& input, const history::CoreHistory& history) {
  const double refinement = input.numerics.mesh_refinement;
  const GridResolution resolution = refined(grid_resolution(input.numerics.preset), refinement);
  const double thickness = history.core_thickness();
  const double width = resolution.column_width * thickness;
  const auto bound = [refinement](std::size_t count) {
    return static_cast<std::size_t>(std::lround(static_cast<double>(count) * refinement));
  };
  const bool at_corner =
      input.has_sheet_resistance() && input.readout.contact == ElectrodeContact::corner;
  const bool uniform_x = history.grid.columns_x() == 1 && history.frame == history::Frame::skin &&
                         !is_cut(input.readout, 0, history.length) && !input.has_sheet_resistance();
  const bool uniform_y = history.grid.columns_y() == 1 && history.slider_y.empty() &&
                         !is_cut(input.readout, 1, history.width) && !at_corner;
  const std::size_t columns_x =
      uniform_x ? 1 : column_count(history.length, width, bound(fewest_x), bound(most_x));
  const std::size_t across = column_count(history.width, width, bound(fewest_y), bound(most_y));
  const std::size_t columns_y = uniform_y ? 1 : across + across % 2;
  // Raises a number of columns so that taxels with a potential of their own have columns of their
  // own.
  const auto resolved = [&](std::size_t count, std::size_t axis, double length) {
    for (std::size_t i = 0; count > 1 && i < input.readout.taxels.size(); ++i) {
      const Taxel& taxel = input.readout.taxels[i];
      if (input.readout.has_own_circuit(i)) {
        const double least = columns_per_taxel * length / (taxel.upper[axis] - taxel.lower[axis]);
        count = std::max(count, static_cast<std::size_t>(std::ceil(least)));
      }
    }
    return count + (axis == 1 && count > 1 ? count % 2 : 0);
  };
  const auto aligned = [&](std::size_t count, std::size_t step, std::size_t axis, double length) {
    std::vector<double> fractions;
    for (const Taxel& taxel : input.readout.taxels) {
      fractions.push_back(taxel.lower[axis] / length);
      fractions.push_back(taxel.upper[axis] / length);
    }
    if (axis == 1 && at_corner) {
      fractions.push_back(corner_share);
    }
    return count == 1 ? count : aligned_column_count(count, step, fractions);
  };
  const double debye_length = derive_scales(input.electrochemistry, thickness).debye_length;
  return {uniform_edges(history.length,
                        aligned(resolved(columns_x, 0, history.length), 1, 0, history.length)),
          uniform_edges(history.width,
                        aligned(resolved(columns_y, 1, history.width), 2, 1, history.width)),
          graded_nodes(thickness, debye_length, resolution)};
}

} // namespace ionskin::electrochemistry
