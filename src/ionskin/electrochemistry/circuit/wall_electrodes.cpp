// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/circuit/wall_electrodes.hpp"

#include "ionskin/base/error.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace ionskin::electrochemistry {
namespace {

/// Shares below this are rounding errors of edges that coincide.
constexpr double share_rounding = 1e-9;

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

} // namespace

WallElectrodes::WallElectrodes(std::vector<WallConductor> conductors)
    : conductors_(std::move(conductors)), columns_(conductors_.front().share.size()),
      on_bottom_(std::ranges::any_of(
          conductors_,
          [](const WallConductor& conductor) { return conductor.wall == bottom_wall; })),
      covered_(conductors_.size()) {
  const auto count = static_cast<Eigen::Index>(conductors_.size());
  Matrix products = Matrix::Zero(count, count);
  std::vector<std::pair<Eigen::Index, double>> here;
  for (const std::size_t wall : {bottom_wall, top_wall}) {
    for (std::size_t i = 0; i < columns_; ++i) {
      here.clear();
      for (std::size_t e = 0; e < conductors_.size(); ++e) {
        const double share = conductors_[e].share[i];
        if (conductors_[e].wall == wall && share > share_rounding) {
          covered_[e].emplace_back(i, share);
          here.emplace_back(static_cast<Eigen::Index>(e), share);
        }
      }
      for (const auto& [a, share_a] : here) {
        for (const auto& [b, share_b] : here) {
          products(a, b) += share_a * share_b;
        }
      }
    }
  }
  const Eigen::LDLT<Matrix> factor(products);
  const auto pivots = factor.vectorD();
  if (pivots.minCoeff() < 1e-6 * pivots.maxCoeff()) {
    throw InternalError("two conductors of a face lie in the same columns");
  }
  const Matrix inverse = factor.solve(Matrix::Identity(count, count));
  inverse_.assign(inverse.data(), inverse.data() + inverse.size());
}

bool WallElectrodes::all_held() const {
  return std::ranges::none_of(
      conductors_, [](const WallConductor& conductor) { return conductor.admittance.has_value(); });
}

std::vector<double> WallElectrodes::sums(std::span<const double> walls) const {
  std::vector<double> result(size());
  for (std::size_t e = 0; e < size(); ++e) {
    const double* columns = walls.data() + first_of(e, walls.size());
    long double sum = 0.0L;
    for (const auto& [column, share] : covered_[e]) {
      sum += share * static_cast<long double>(columns[column]);
    }
    result[e] = static_cast<double>(sum);
  }
  return result;
}

void WallElectrodes::spread(std::span<const double> potentials, std::span<double> walls) const {
  std::ranges::fill(walls.last(columns_), 0.0);
  if (on_bottom_) {
    std::ranges::fill(walls.first(columns_), 0.0);
  }
  for (std::size_t e = 0; e < size(); ++e) {
    double* columns = walls.data() + first_of(e, walls.size());
    for (const auto& [column, share] : covered_[e]) {
      columns[column] += share * potentials[e];
    }
  }
}

std::vector<double> WallElectrodes::potentials(std::span<const double> walls) const {
  return solved(sums(walls));
}

void WallElectrodes::add(std::span<const double> sums, std::span<double> walls) const {
  const std::vector<double> weights = solved({sums.begin(), sums.end()});
  for (std::size_t e = 0; e < size(); ++e) {
    double* columns = walls.data() + first_of(e, walls.size());
    for (const auto& [column, share] : covered_[e]) {
      columns[column] += share * weights[e];
    }
  }
}

std::vector<double> WallElectrodes::solved(std::vector<double> sums) const {
  std::vector<double> result(size(), 0.0);
  for (std::size_t e = 0; e < size(); ++e) {
    for (std::size_t f = 0; f < size(); ++f) {
      result[e] += inverse_[e * size() + f] * sums[f];
    }
  }
  return result;
}

bool ElectrodeStage::holds(std::size_t conductor) const {
  return std::isinf(conductance[conductor]);
}

} // namespace ionskin::electrochemistry
