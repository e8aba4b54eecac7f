// SPDX-License-Identifier: Apache-2.0
#include "ionskin/poroelasticity/line_modes.hpp"

#include "ionskin/base/error.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <limits>
#include <numbers>

namespace ionskin::poroelasticity {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using std::numbers::pi;

std::vector<double> values_of(const RowMajor& matrix) {
  return {matrix.data(), matrix.data() + matrix.size()};
}

} // namespace

LineModes cosine_modes(std::size_t columns, double width) {
  const auto n = static_cast<double>(columns);
  LineModes modes{columns, {}, std::vector<double>(columns * columns), {}};
  modes.from_modes.resize(columns * columns);
  for (std::size_t m = 0; m < columns; ++m) {
    const double wave = pi * static_cast<double>(m) / n;
    const double half_sine = 2.0 * std::sin(0.5 * wave) / width;
    modes.curvature.push_back(half_sine * half_sine);
    for (std::size_t i = 0; i < columns; ++i) {
      const double value =
          std::sqrt((m == 0 ? 1.0 : 2.0) / n) * std::cos(wave * (static_cast<double>(i) + 0.5));
      modes.to_modes[m * columns + i] = modes.from_modes[i * columns + m] = value;
    }
  }
  return modes;
}

LineModes wall_modes(const std::vector<double>& nodes, const WaterWalls& walls, double held_share) {
  const auto size = static_cast<Eigen::Index>(nodes.size());
  const Eigen::Index first = walls.bottom == open_wall ? 1 : 0;
  const Eigen::Index count = size - first - (walls.top == open_wall ? 1 : 0);
  if (size < 3 || size % 2 == 0) {
    throw InternalError("quadratic elements have an odd number of nodes");
  }
  const std::vector<double> lengths = node_lengths(nodes);
  const Eigen::VectorXd root_mass =
      Eigen::Map<const Eigen::VectorXd>(lengths.data(), size).cwiseSqrt();
  const Eigen::VectorXd inverse = root_mass.cwiseInverse();
  RowMajor stiffness = RowMajor::Zero(size, size);
  for (Eigen::Index i = 0; i + 2 < size; i += 2) {
    const double length =
        nodes[static_cast<std::size_t>(i) + 2] - nodes[static_cast<std::size_t>(i)];
    stiffness.block<3, 3>(i, i) +=
        Eigen::Matrix3d{{7, -8, 1}, {-8, 16, -8}, {1, -8, 7}} / (3 * length);
  }
  stiffness(0, 0) += first == 1 ? 0.0 : walls.bottom;
  stiffness(size - 1, size - 1) += walls.top == open_wall ? 0.0 : walls.top;
  const RowMajor scaled =
      (inverse.asDiagonal() * stiffness * inverse.asDiagonal()).block(first, first, count, count);
  const Eigen::VectorXd even = root_mass.segment(first, count) / root_mass.norm();
  const Eigen::GeneralizedSelfAdjointEigenSolver<RowMajor> solver(
      scaled, RowMajor::Identity(count, count) - held_share * even * even.transpose());
  const bool is_sealed = walls.bottom == sealed_wall && walls.top == sealed_wall;
  LineModes modes{nodes.size(), std::vector<double>(nodes.size(), 0.0), {}, {}};
  RowMajor to_modes = RowMajor::Zero(size, size), from_modes = RowMajor::Zero(size, size);
  for (Eigen::Index m = 0; m < count; ++m) {
    const bool uniform = m == 0 && is_sealed;
    modes.curvature[static_cast<std::size_t>(m)] = uniform ? 0.0 : solver.eigenvalues()(m);
    // The uniform mode is known exactly, so water is conserved to rounding.
    const Eigen::VectorXd vector = uniform ? Eigen::VectorXd(even / std::sqrt(1 - held_share))
                                           : Eigen::VectorXd(solver.eigenvectors().col(m));
    for (Eigen::Index i = 0; i < count; ++i) {
      to_modes(m, first + i) = vector(i) * root_mass(first + i);
      from_modes(first + i, m) = vector(i) * inverse(first + i);
    }
  }
  for (Eigen::Index m = count; m < size; ++m) {
    const Eigen::Index at = m == count && first == 1 ? 0 : size - 1;
    modes.curvature[static_cast<std::size_t>(m)] = std::numeric_limits<double>::infinity();
    to_modes(m, at) = from_modes(at, m) = 1;
  }
  modes.to_modes = values_of(to_modes);
  modes.from_modes = values_of(from_modes);
  return modes;
}

std::vector<double> node_lengths(const std::vector<double>& nodes) {
  std::vector<double> lengths(nodes.size(), 0.0);
  for (std::size_t i = 0; i + 2 < nodes.size(); i += 2) {
    const double sixth = (nodes[i + 2] - nodes[i]) / 6;
    lengths[i] += sixth;
    lengths[i + 1] += 4 * sixth;
    lengths[i + 2] += sixth;
  }
  return lengths;
}

history::LineOperator quadratic_interpolation(const std::vector<double>& nodes,
                                              const std::vector<double>& places) {
  history::LineOperator line;
  line.sources = nodes.size();
  std::size_t element = 0;
  for (const double place : places) {
    while (element + 4 < nodes.size() && nodes[element + 2] < place) {
      element += 2;
    }
    const double t = (place - nodes[element]) / (nodes[element + 2] - nodes[element]);
    line.first.push_back(element);
    line.weights.push_back({(1 - t) * (1 - 2 * t), 4 * t * (1 - t), t * (2 * t - 1)});
  }
  return line;
}

std::vector<double> wall_clustered_nodes(double thickness, std::size_t elements) {
  std::vector<double> nodes{0.0};
  for (std::size_t i = 1; i <= elements; ++i) {
    const double half_sine =
        std::sin(0.5 * pi * static_cast<double>(i) / static_cast<double>(elements));
    const double end = i == elements ? thickness : thickness * half_sine * half_sine;
    nodes.push_back(0.5 * (nodes.back() + end));
    nodes.push_back(end);
  }
  return nodes;
}

} // namespace ionskin::poroelasticity
