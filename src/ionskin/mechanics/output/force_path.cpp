// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/output/force_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ionskin::mechanics {
namespace {

/// Sum of the magnitudes of force components [N].
double sum_of_sizes(const std::vector<double>& force) {
  double sum = 0;
  for (const double value : force) {
    sum += std::abs(value);
  }
  return sum;
}

} // namespace

ForcePath::Instant ForcePath::at(double time) const {
  const auto after = std::ranges::upper_bound(instants, time, {}, &Instant::time);
  if (after == instants.begin()) {
    return instants.front();
  }
  if (after == instants.end()) {
    return instants.back();
  }
  const Instant& before = *(after - 1);
  const double share = (time - before.time) / (after->time - before.time);
  Instant result = before;
  result.time = time;
  for (std::size_t d = 0; d < 2; ++d) {
    result.centre[d] += share * (after->centre[d] - before.centre[d]);
  }
  for (std::size_t i = 0; i < result.force.size(); ++i) {
    result.force[i] += share * (after->force[i] - before.force[i]);
  }
  return result;
}

ForcePath force_path(const ContactSolution& solution) {
  const std::vector<double>&x = solution.cell_lines_x, &y = solution.cell_lines_y;
  ForcePath path{x, y, {}, solution.mesh.half_model()};
  const std::size_t columns = x.size() - 1, cells = columns * (y.size() - 1);
  for (const SteppedInstant& instant : solution.stepped) {
    std::vector<double> force(3 * cells, 0.0);
    for (std::size_t cell = 0; instant.state && cell < cells; ++cell) {
      const std::size_t i = cell % columns, j = cell / columns;
      const double area = (x[i + 1] - x[i]) * (y[j + 1] - y[j]);
      force[3 * cell] = area * instant.state->normal_traction[cell];
      force[3 * cell + 1] = area * instant.state->tangential_traction_x[cell];
      force[3 * cell + 2] = area * instant.state->tangential_traction_y[cell];
    }
    path.instants.push_back({instant.time, instant.centre, std::move(force)});
  }
  return path;
}

double change_of_forces(const ForcePath& now, const ForcePath& before) {
  if (now.lines_x != before.lines_x || now.lines_y != before.lines_y) {
    return std::numeric_limits<double>::infinity();
  }
  double largest = 0, change = 0;
  for (const ForcePath::Instant& instant : now.instants) {
    std::vector<double> difference = before.at(instant.time).force;
    for (std::size_t i = 0; i < difference.size(); ++i) {
      difference[i] -= instant.force[i];
    }
    largest = std::max(largest, sum_of_sizes(instant.force));
    change = std::max(change, sum_of_sizes(difference));
  }
  return change > 0 ? change / largest : 0;
}

double distance(const std::array<double, 2>& centre, const std::array<double, 2>& half_size,
                const std::array<double, 2>& other_centre,
                const std::array<double, 2>& other_half_size) {
  std::array<double, 2> apart{};
  for (std::size_t d = 0; d < 2; ++d) {
    apart[d] =
        std::max(0.0, std::abs(centre[d] - other_centre[d]) - half_size[d] - other_half_size[d]);
  }
  return std::hypot(apart[0], apart[1]);
}

} // namespace ionskin::mechanics
