// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/circuit/top_electrodes.hpp"

#include "ionskin/base/error.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace ionskin::electrochemistry {
namespace {

/// Shares below this are rounding of edges that coincide.
constexpr double share_rounding = 1e-9;

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

} // namespace

TopElectrodes::TopElectrodes(std::vector<TopConductor> conductors)
    : conductors_(std::move(conductors)), covered_(conductors_.size()) {
  const auto count = static_cast<Eigen::Index>(conductors_.size());
  const std::size_t columns = conductors_.front().share.size();
  Matrix products = Matrix::Zero(count, count);
  std::vector<std::pair<Eigen::Index, double>> here;
  for (std::size_t i = 0; i < columns; ++i) {
    here.clear();
    for (std::size_t e = 0; e < conductors_.size(); ++e) {
      const double share = conductors_[e].share[i];
      if (share > share_rounding) {
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
  const Eigen::LDLT<Matrix> factor(products);
  const auto pivots = factor.vectorD();
  if (pivots.minCoeff() < 1e-6 * pivots.maxCoeff()) {
    throw InternalError("two conductors of the top face lie in the same columns");
  }
  const Matrix inverse = factor.solve(Matrix::Identity(count, count));
  inverse_.assign(inverse.data(), inverse.data() + inverse.size());
}

bool TopElectrodes::all_held() const {
  return std::ranges::none_of(
      conductors_, [](const TopConductor& conductor) { return conductor.admittance.has_value(); });
}

std::vector<double> TopElectrodes::sums(std::span<const double> columns) const {
  std::vector<double> result(size());
  for (std::size_t e = 0; e < size(); ++e) {
    long double sum = 0.0L;
    for (const auto& [column, share] : covered_[e]) {
      sum += share * static_cast<long double>(columns[column]);
    }
    result[e] = static_cast<double>(sum);
  }
  return result;
}

void TopElectrodes::spread(std::span<const double> potentials, std::span<double> columns) const {
  std::ranges::fill(columns, 0.0);
  for (std::size_t e = 0; e < size(); ++e) {
    for (const auto& [column, share] : covered_[e]) {
      columns[column] += share * potentials[e];
    }
  }
}

std::vector<double> TopElectrodes::potentials(std::span<const double> columns) const {
  return solved(sums(columns));
}

void TopElectrodes::add(std::span<const double> sums, std::span<double> columns) const {
  const std::vector<double> weights = solved({sums.begin(), sums.end()});
  for (std::size_t e = 0; e < size(); ++e) {
    for (const auto& [column, share] : covered_[e]) {
      columns[column] += share * weights[e];
    }
  }
}

std::vector<double> TopElectrodes::solved(std::vector<double> sums) const {
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
