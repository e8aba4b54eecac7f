// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/training/charge_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ionskin::live {
namespace {

constexpr double regularisation = 1e-10;  // of a column's square
constexpr double fitted_share = 2.0 / 3;  // of the rows; the rest says how many rates are enough
constexpr double negligible_error = 1e-4; // of the charges
constexpr double worthwhile = 0.9;        // error with another rate over that without

/// Normal equations of both charges by the drive and by it behind every low pass.
struct Normal {
  Eigen::MatrixXd gram, right; ///< [(1 + rates) inputs][same], [same][2]
  double square = 0;           ///< of all charges
};

/// Of the rows between two parts of each record.
Normal normal_equations(const std::vector<ChargeRecord>& records, std::size_t inputs,
                        const std::vector<double>& rates, double from = 0, double to = 1) {
  const auto m = static_cast<Eigen::Index>(inputs),
             size = m * static_cast<Eigen::Index>(1 + rates.size());
  Normal normal{Eigen::MatrixXd::Zero(size, size), Eigen::MatrixXd::Zero(size, 2), 0};
  for (const ChargeRecord& record : records) {
    Eigen::VectorXd row = Eigen::VectorXd::Zero(size), before = Eigen::VectorXd::Zero(m);
    for (std::size_t i = 0; i < record.time.size(); ++i) {
      const Eigen::Map<const Eigen::VectorXd> now(record.drive.data() + i * inputs, m);
      const double step = i == 0 ? 0 : record.time[i] - record.time[i - 1];
      row.head(m) = now;
      for (std::size_t r = 0; r < rates.size() && step > 0; ++r) {
        const double z = rates[r] * step, decay = std::exp(-z),
                     mean = z > 1e-8 ? -std::expm1(-z) / z : 1 - z / 2;
        auto filtered = row.segment(m * static_cast<Eigen::Index>(1 + r), m);
        filtered = decay * filtered + (mean - decay) * before + (1 - mean) * now;
      }
      before = now;
      const double part = static_cast<double>(i) / static_cast<double>(record.time.size());
      if (part < from || part >= to) {
        continue;
      }
      const Eigen::RowVector2d charge(record.charge[0][i], record.charge[1][i]);
      // A row for itself counts too, or short contacts would not.
      const double weight = step + 1e-3;
      normal.gram.selfadjointView<Eigen::Lower>().rankUpdate(row, weight);
      normal.right += weight * row * charge;
      normal.square += weight * charge.squaredNorm();
    }
  }
  normal.gram = normal.gram.selfadjointView<Eigen::Lower>();
  return normal;
}

struct Fit {
  Eigen::MatrixXd weights; ///< [chosen columns][2]
  double left = 0;         ///< square of what is left
};

/// Those of the instantaneous part and of some of the rates.
std::vector<Eigen::Index> columns_of(std::size_t inputs, const std::vector<std::size_t>& rates) {
  std::vector<Eigen::Index> columns;
  for (std::size_t i = 0; i < inputs * (1 + rates.size()); ++i) {
    const std::size_t block = i / inputs == 0 ? 0 : 1 + rates[i / inputs - 1];
    columns.push_back(static_cast<Eigen::Index>(block * inputs + i % inputs));
  }
  return columns;
}

Fit fit_with(const Normal& normal, std::size_t inputs, const std::vector<std::size_t>& rates) {
  const std::vector<Eigen::Index> columns = columns_of(inputs, rates);
  Eigen::MatrixXd gram = normal.gram(columns, columns);
  Eigen::MatrixXd right = normal.right(columns, Eigen::indexing::all);
  const double floor =
      std::max(gram.diagonal().maxCoeff() * 1e-30, std::numeric_limits<double>::min());
  const Eigen::VectorXd scale = gram.diagonal().cwiseMax(floor).cwiseSqrt().cwiseInverse();
  gram = scale.asDiagonal() * gram * scale.asDiagonal();
  gram.diagonal().array() += regularisation;
  const Eigen::MatrixXd scaled = scale.asDiagonal() * right;
  const Eigen::MatrixXd solution = gram.ldlt().solve(scaled);
  return {scale.asDiagonal() * solution, normal.square - (solution.cwiseProduct(scaled)).sum()};
}

/// Square of what a fit leaves of other rows.
double left_of(const Normal& unseen, std::size_t inputs, const std::vector<std::size_t>& rates,
               const Eigen::MatrixXd& weights) {
  const std::vector<Eigen::Index> columns = columns_of(inputs, rates);
  const Eigen::MatrixXd gram = unseen.gram(columns, columns);
  const Eigen::MatrixXd right = unseen.right(columns, Eigen::indexing::all);
  return unseen.square - 2 * weights.cwiseProduct(right).sum() +
         weights.cwiseProduct(gram * weights).sum();
}

} // namespace

std::vector<double> choose_rates(const std::vector<ChargeRecord>& records, std::size_t inputs,
                                 const std::vector<double>& candidates, std::size_t least,
                                 std::size_t most) {
  const Normal fitted = normal_equations(records, inputs, candidates, 0, fitted_share),
               unseen = normal_equations(records, inputs, candidates, fitted_share, 1);
  std::vector<std::size_t> chosen, enough;
  double error = std::numeric_limits<double>::infinity();
  while (chosen.size() < std::min(most, candidates.size()) &&
         (chosen.size() < least || error > negligible_error * std::sqrt(unseen.square))) {
    std::size_t best = 0;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t candidate = 0; candidate < candidates.size(); ++candidate) {
      if (std::ranges::find(chosen, candidate) != chosen.end()) {
        continue;
      }
      chosen.push_back(candidate);
      const double left = fit_with(fitted, inputs, chosen).left;
      chosen.pop_back();
      if (left < smallest) {
        smallest = left;
        best = candidate;
      }
    }
    chosen.push_back(best);
    const double now = std::sqrt(
        std::max(0.0, left_of(unseen, inputs, chosen, fit_with(fitted, inputs, chosen).weights)));
    if (chosen.size() <= least ||
        now < std::pow(worthwhile, chosen.size() - enough.size()) * error) {
      enough = chosen;
      error = now;
    }
  }
  std::vector<double> rates;
  for (const std::size_t index : enough) {
    rates.push_back(candidates[index]);
  }
  std::ranges::sort(rates);
  return rates;
}

ChargeModel fit_charges(const std::vector<ChargeRecord>& records, std::size_t inputs,
                        const std::vector<double>& rates) {
  std::vector<std::size_t> all(rates.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = i;
  }
  const Fit fit = fit_with(normal_equations(records, inputs, rates), inputs, all);
  ChargeModel model{inputs, {}, {}};
  for (Eigen::Index side = 0; side < 2; ++side) {
    for (Eigen::Index i = 0; i < fit.weights.rows(); ++i) {
      (i < static_cast<Eigen::Index>(inputs) ? model.direct : model.residue)
          .push_back(fit.weights(i, side));
    }
  }
  return model;
}

} // namespace ionskin::live
