// SPDX-License-Identifier: Apache-2.0
#include "mechanics/solid_elements.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace ionskin::verification {
namespace {

constexpr std::size_t nodes_of_element = 27;
/// Gauss' rule with three points on [0, 1].
const std::array<double, 3> points{0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15)};
constexpr std::array<double, 3> weights{5.0 / 18, 8.0 / 18, 5.0 / 18};
/// Integrals of the shape functions over [0, 1].
constexpr std::array<double, 3> shares{1.0 / 6, 4.0 / 6, 1.0 / 6};

/// Quadratic shape functions on [0, 1] with nodes at 0, 1/2 and 1, and their slopes.
std::array<double, 3> values(double t) {
  return {(1 - t) * (1 - 2 * t), 4 * t * (1 - t), t * (2 * t - 1)};
}
std::array<double, 3> slopes(double t) {
  return {4 * t - 3, 4 - 8 * t, 4 * t - 1};
}

/// Slopes of all shape functions, [direction, node].
Eigen::Matrix<double, 3, nodes_of_element> gradient(const std::array<double, 3>& local,
                                                    const std::array<double, 3>& size) {
  std::array<std::array<double, 3>, 3> value{}, slope{};
  for (std::size_t d = 0; d < 3; ++d) {
    value[d] = values(local[d]);
    slope[d] = slopes(local[d]);
  }
  Eigen::Matrix<double, 3, nodes_of_element> result;
  for (std::size_t n = 0; n < nodes_of_element; ++n) {
    const std::array<std::size_t, 3> at{n % 3, n / 3 % 3, n / 9};
    for (std::size_t d = 0; d < 3; ++d) {
      double product = slope[d][at[d]] / size[d];
      for (std::size_t other = 0; other < 3; ++other) {
        product *= other == d ? 1.0 : value[other][at[other]];
      }
      result(static_cast<Eigen::Index>(d), static_cast<Eigen::Index>(n)) = product;
    }
  }
  return result;
}

using ElementMatrix = Eigen::Matrix<double, 3 * nodes_of_element, 3 * nodes_of_element>;

/// Strains in the order xx, yy, zz, 2 yz, 2 xz, 2 xy over the displacements of the nodes.
Eigen::Matrix<double, 6, 3 * nodes_of_element>
strain_matrix(const Eigen::Matrix<double, 3, nodes_of_element>& g) {
  Eigen::Matrix<double, 6, 3 * nodes_of_element> b;
  b.setZero();
  for (Eigen::Index n = 0; n < g.cols(); ++n) {
    for (Eigen::Index d = 0; d < 3; ++d) {
      b(d, 3 * n + d) = g(d, n);
    }
    b(3, 3 * n + 1) = b(4, 3 * n) = g(2, n);
    b(3, 3 * n + 2) = b(5, 3 * n) = g(1, n);
    b(4, 3 * n + 2) = b(5, 3 * n + 1) = g(0, n);
  }
  return b;
}

ElementMatrix stiffness(const std::array<double, 3>& size, const SolidElements::Lame& law) {
  Eigen::Matrix<double, 6, 6> elastic = Eigen::Matrix<double, 6, 6>::Zero();
  elastic.topLeftCorner<3, 3>().setConstant(law.lambda);
  elastic.diagonal() << Eigen::Vector3d::Constant(law.lambda + 2 * law.mu),
      Eigen::Vector3d::Constant(law.mu);
  ElementMatrix result = ElementMatrix::Zero();
  for (std::size_t q = 0; q < nodes_of_element; ++q) {
    const std::array<std::size_t, 3> at{q % 3, q / 3 % 3, q / 9};
    const auto b = strain_matrix(gradient({points[at[0]], points[at[1]], points[at[2]]}, size));
    const double weight =
        weights[at[0]] * weights[at[1]] * weights[at[2]] * size[0] * size[1] * size[2];
    result += weight * b.transpose() * elastic * b;
  }
  return result;
}

/// Index of the first element, and of one past the last, between two mesh lines. Throws
/// std::logic_error when an end is no mesh line.
std::array<std::size_t, 2> range(const std::vector<double>& lines,
                                 const std::array<double, 2>& between) {
  std::array<std::size_t, 2> result{};
  for (std::size_t end = 0; end < 2; ++end) {
    const auto nearest = std::ranges::min_element(
        lines, {}, [&](double line) { return std::abs(line - between[end]); });
    if (std::abs(*nearest - between[end]) > 1e-9 * lines.back()) {
      throw std::logic_error("a patch does not end at a line of the mesh");
    }
    result[end] = static_cast<std::size_t>(nearest - lines.begin());
  }
  return result;
}

} // namespace

SolidElements::SolidElements(Lines lines, const std::vector<Lame>& rows,
                             const std::vector<Patch>& patches)
    : lines_(std::move(lines)) {
  const auto& [x, y, z] = lines_.of;
  const std::size_t nx = x.size() - 1, ny = y.size() - 1, nz = z.size() - 1;
  const auto size_of_all =
      static_cast<Eigen::Index>(3 * (2 * nx + 1) * (2 * ny + 1) * (2 * nz + 1));
  const std::size_t below = (2 * ny + 1) * (2 * nz + 1), across = 2 * nz + 1;
  const auto held = [&](std::size_t unknown) {
    const std::size_t at = unknown / 3;
    return at % across == 0 || (unknown % 3 == 1 && at % below / across == 2 * ny);
  };
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < nx; ++i) {
    for (std::size_t j = 0; j < ny; ++j) {
      for (std::size_t k = 0; k < nz; ++k) {
        const Element element{i, j, k};
        const ElementMatrix own =
            stiffness({size(element, 0), size(element, 1), size(element, 2)}, rows[k]);
        for (std::size_t a = 0; a < 3 * nodes_of_element; ++a) {
          const std::size_t row = 3 * node(element, a / 3) + a % 3;
          for (std::size_t b = 0; b < 3 * nodes_of_element; ++b) {
            const std::size_t column = 3 * node(element, b / 3) + b % 3;
            if (row >= column && !held(row) && !held(column)) {
              entries.emplace_back(static_cast<int>(row), static_cast<int>(column),
                                   own(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)));
            }
          }
        }
      }
    }
  }
  for (std::size_t unknown = 0; unknown < static_cast<std::size_t>(size_of_all); ++unknown) {
    if (held(unknown)) {
      entries.emplace_back(static_cast<int>(unknown), static_cast<int>(unknown), 1.0);
    }
  }
  Eigen::VectorXd load = Eigen::VectorXd::Zero(size_of_all);
  for (const Patch& patch : patches) {
    const auto in_x = range(x, patch.x), in_y = range(y, patch.y);
    const double area = (patch.x[1] - patch.x[0]) * (patch.y[1] - patch.y[0]);
    for (std::size_t i = in_x[0]; i < in_x[1]; ++i) {
      for (std::size_t j = in_y[0]; j < in_y[1]; ++j) {
        const Element element{i, j, nz - 1};
        const double part = size(element, 0) * size(element, 1) / area;
        for (std::size_t n = 0; n < 9; ++n) {
          for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t unknown = 3 * node(element, 18 + n) + c;
            load[static_cast<Eigen::Index>(unknown)] +=
                held(unknown) ? 0.0 : part * shares[n % 3] * shares[n / 3] * patch.force[c];
          }
        }
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(size_of_all, size_of_all);
  matrix.setFromTriplets(entries.begin(), entries.end());
  displacement_ = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(load);
}

/// Index of a node. Nodes are numbered along z first and x last, so that the matrix is a narrow
/// band.
std::size_t SolidElements::node(const Element& element, std::size_t local) const {
  const std::size_t rows = 2 * lines_.of[1].size() - 1, levels = 2 * lines_.of[2].size() - 1;
  return ((2 * element[0] + local % 3) * rows + 2 * element[1] + local / 3 % 3) * levels +
         2 * element[2] + local / 9;
}

double SolidElements::size(const Element& element, std::size_t direction) const {
  const std::vector<double>& lines = lines_.of[direction];
  return lines[element[direction] + 1] - lines[element[direction]];
}

std::array<double, 3> SolidElements::mean_of_top(const std::array<double, 2>& x,
                                                 const std::array<double, 2>& y) const {
  const auto in_x = range(lines_.of[0], x), in_y = range(lines_.of[1], y);
  std::array<double, 3> result{};
  for (std::size_t i = in_x[0]; i < in_x[1]; ++i) {
    for (std::size_t j = in_y[0]; j < in_y[1]; ++j) {
      const Element element{i, j, lines_.of[2].size() - 2};
      const double part = size(element, 0) * size(element, 1) / ((x[1] - x[0]) * (y[1] - y[0]));
      for (std::size_t n = 0; n < 9; ++n) {
        for (std::size_t c = 0; c < 3; ++c) {
          result[c] += part * shares[n % 3] * shares[n / 3] *
                       displacement_[static_cast<Eigen::Index>(3 * node(element, 18 + n) + c)];
        }
      }
    }
  }
  return result;
}

SolidElements::Strain SolidElements::strain_in(const Element& element,
                                               const std::array<double, 3>& local) const {
  Eigen::Matrix<double, 3 * nodes_of_element, 1> own;
  for (std::size_t a = 0; a < 3 * nodes_of_element; ++a) {
    own[static_cast<Eigen::Index>(a)] =
        displacement_[static_cast<Eigen::Index>(3 * node(element, a / 3) + a % 3)];
  }
  const Eigen::Matrix<double, 6, 1> strain =
      strain_matrix(gradient(local, {size(element, 0), size(element, 1), size(element, 2)})) * own;
  return {strain[0], strain[1], strain[2], strain[3] / 2, strain[4] / 2, strain[5] / 2};
}

SolidElements::Strain SolidElements::strain(const std::array<double, 3>& place) const {
  Element element{};
  std::array<double, 3> local{};
  for (std::size_t d = 0; d < 3; ++d) {
    const std::vector<double>& lines = lines_.of[d];
    const auto behind = std::ranges::upper_bound(lines, place[d]) - lines.begin();
    element[d] = std::clamp<std::size_t>(static_cast<std::size_t>(behind), 1, lines.size() - 1) - 1;
    local[d] = (place[d] - lines[element[d]]) / size(element, d);
  }
  return strain_in(element, local);
}

SolidElements::Strain
SolidElements::mean_strain(const std::array<std::array<double, 2>, 3>& box) const {
  std::array<std::array<std::size_t, 2>, 3> in{};
  double volume = 1;
  for (std::size_t d = 0; d < 3; ++d) {
    in[d] = range(lines_.of[d], box[d]);
    volume *= box[d][1] - box[d][0];
  }
  Strain result{};
  for (std::size_t i = in[0][0]; i < in[0][1]; ++i) {
    for (std::size_t j = in[1][0]; j < in[1][1]; ++j) {
      for (std::size_t k = in[2][0]; k < in[2][1]; ++k) {
        const Element element{i, j, k};
        for (std::size_t q = 0; q < nodes_of_element; ++q) {
          const std::array<std::size_t, 3> at{q % 3, q / 3 % 3, q / 9};
          const Strain here = strain_in(element, {points[at[0]], points[at[1]], points[at[2]]});
          const double part = weights[at[0]] * weights[at[1]] * weights[at[2]] * size(element, 0) *
                              size(element, 1) * size(element, 2) / volume;
          for (std::size_t c = 0; c < 6; ++c) {
            result[c] += part * here[c];
          }
        }
      }
    }
  }
  return result;
}

} // namespace ionskin::verification
