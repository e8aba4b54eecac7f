// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/training/charge_fit.hpp"

#include "ionskin/live/low_pass.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ionskin::live {
namespace {

constexpr double regularisation = 1e-10; ///< ridge of the fit, over the square of a column [1]
/// Share of the rows that is fitted; the other rows measure the error and show how many rates are
/// enough [1].
constexpr double fitted_share = 2.0 / 3;
/// Error, over the norm of the charges, at which no more rates are added [1].
constexpr double negligible_error = 1e-4;
/// Largest ratio of the error with another rate to the error without it, for adding the rate [1].
constexpr double worthwhile = 0.9;

/// Normal equations of the least-squares fit of half the sum and half the difference of the charges
/// of both electrodes. The columns are the inputs, the inputs behind the low pass of each rate, and
/// the waves of spreading charge by z level.
struct Normal {
  Eigen::MatrixXd gram, right; ///< [(1 + rates) inputs + spread][same], [same][sum, difference]
  double square = 0;           ///< weighted sum of the squares of what is fitted [C2 s]
  std::size_t spread = 0;      ///< number of columns of the spreading charge
};

/// Sets up the normal equations for a part of the rows of each record.
/// @param from, to begin and end of the part, over the number of rows [1]
Normal normal_equations(const std::vector<ChargeRecord>& records, std::size_t inputs,
                        const std::vector<double>& rates, double from = 0, double to = 1) {
  const std::size_t spread = records.front().spread.size() / records.front().time.size();
  const auto m = static_cast<Eigen::Index>(inputs), spreads = static_cast<Eigen::Index>(spread),
             size = m * static_cast<Eigen::Index>(1 + rates.size()) + spreads;
  Normal normal{Eigen::MatrixXd::Zero(size, size), Eigen::MatrixXd::Zero(size, 2), 0, spread};
  for (const ChargeRecord& record : records) {
    Eigen::VectorXd row = Eigen::VectorXd::Zero(size), before = Eigen::VectorXd::Zero(m);
    for (std::size_t i = 0; i < record.time.size(); ++i) {
      const Eigen::Map<const Eigen::VectorXd> now(record.drive.data() + i * inputs, m);
      const double step = i == 0 ? 0 : record.time[i] - record.time[i - 1];
      row.head(m) = now;
      for (std::size_t r = 0; r < rates.size() && step > 0; ++r) {
        const LowPass pass = LowPass::over(rates[r], step);
        auto filtered = row.segment(m * static_cast<Eigen::Index>(1 + r), m);
        filtered = pass.decay * filtered + pass.before * before + pass.now * now;
      }
      before = now;
      row.tail(spreads) =
          Eigen::Map<const Eigen::VectorXd>(record.spread.data() + i * spread, spreads);
      const double part = static_cast<double>(i) / static_cast<double>(record.time.size());
      if (part < from || part >= to) {
        continue;
      }
      const Eigen::RowVector2d charge((record.charge[0][i] + record.charge[1][i]) / 2,
                                      (record.charge[0][i] - record.charge[1][i]) / 2);
      // The constant gives every row a weight [s]; otherwise short time steps, as in short
      // contacts, would not count.
      const double weight = step + 1e-3;
      normal.gram.selfadjointView<Eigen::Lower>().rankUpdate(row, weight);
      normal.right += weight * row * charge;
      normal.square += weight * charge.squaredNorm();
    }
  }
  normal.gram = normal.gram.selfadjointView<Eigen::Lower>();
  return normal;
}

/// Result of a fit.
struct Fit {
  std::vector<Eigen::Index> columns; ///< indices of the fitted columns of `Normal`
  Eigen::MatrixXd weights;           ///< weights of these columns [column][sum, difference]
};

/// Indices of the columns of the instantaneous part and of some of the rates.
/// @param rates indices of the rates
std::vector<Eigen::Index> columns_of(std::size_t inputs, const std::vector<std::size_t>& rates) {
  std::vector<Eigen::Index> columns;
  for (std::size_t i = 0; i < inputs * (1 + rates.size()); ++i) {
    const std::size_t block = i / inputs == 0 ? 0 : 1 + rates[i / inputs - 1];
    columns.push_back(static_cast<Eigen::Index>(block * inputs + i % inputs));
  }
  return columns;
}

/// Weights that fit some of the columns best [column][sum, difference].
Eigen::MatrixXd solve_with(const Normal& normal, const std::vector<Eigen::Index>& columns) {
  Eigen::MatrixXd gram = normal.gram(columns, columns);
  const double floor =
      std::max(gram.diagonal().maxCoeff() * 1e-30, std::numeric_limits<double>::min());
  const Eigen::VectorXd scale = gram.diagonal().cwiseMax(floor).cwiseSqrt().cwiseInverse();
  gram = scale.asDiagonal() * gram * scale.asDiagonal();
  gram.diagonal().array() += regularisation;
  return scale.asDiagonal() *
         gram.ldlt().solve(scale.asDiagonal() * normal.right(columns, Eigen::indexing::all));
}

/// Weighted sum of the squared residuals of a fit [C2 s].
double left_of(const Normal& normal, const std::vector<Eigen::Index>& columns,
               const Eigen::MatrixXd& weights) {
  const Eigen::MatrixXd gram = normal.gram(columns, columns);
  const Eigen::MatrixXd right = normal.right(columns, Eigen::indexing::all);
  return normal.square - 2 * weights.cwiseProduct(right).sum() +
         weights.cwiseProduct(gram * weights).sum();
}

/// Fits the columns of some rates, and the spreading charge. As spreading charge is equal on top
/// and bottom, it is part of half the sum only.
/// @param rates indices of the rates
Fit fit_with(const Normal& normal, std::size_t inputs, const std::vector<std::size_t>& rates) {
  Fit fit{columns_of(inputs, rates), {}};
  fit.weights = solve_with(normal, fit.columns);
  if (normal.spread > 0) {
    const auto own = static_cast<Eigen::Index>(fit.columns.size()),
               spreads = static_cast<Eigen::Index>(normal.spread);
    for (Eigen::Index i = 0; i < spreads; ++i) {
      fit.columns.push_back(normal.gram.rows() - spreads + i);
    }
    const Eigen::VectorXd difference = fit.weights.col(1);
    fit.weights = solve_with(normal, fit.columns);
    fit.weights.col(1).setZero();
    fit.weights.col(1).head(own) = difference;
  }
  return fit;
}

std::vector<std::size_t> all_of(const std::vector<double>& rates) {
  std::vector<std::size_t> all(rates.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

} // namespace

std::vector<double> choose_rates(const std::vector<ChargeGroup>& groups,
                                 const std::vector<double>& candidates, std::size_t least,
                                 std::size_t most) {
  std::vector<Normal> fitted, unseen;
  for (const ChargeGroup& group : groups) {
    fitted.push_back(normal_equations(group.records, group.inputs, candidates, 0, fitted_share));
    unseen.push_back(normal_equations(group.records, group.inputs, candidates, fitted_share, 1));
  }
  // Sum over the groups of the squared error over the square of the charges, on some rows, of the
  // fit to the fitted rows.
  const auto error_on = [&](const std::vector<Normal>& rows,
                            const std::vector<std::size_t>& rates) {
    double sum = 0;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const Fit fit = fit_with(fitted[i], groups[i].inputs, rates);
      sum += std::max(0.0, left_of(rows[i], fit.columns, fit.weights)) /
             std::max(rows[i].square, std::numeric_limits<double>::min());
    }
    return sum;
  };
  std::vector<std::size_t> chosen, enough;
  double error = std::numeric_limits<double>::infinity();
  while (chosen.size() < std::min(most, candidates.size()) &&
         (chosen.size() < least || error > negligible_error)) {
    std::size_t best = 0;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t candidate = 0; candidate < candidates.size(); ++candidate) {
      if (std::ranges::find(chosen, candidate) != chosen.end()) {
        continue;
      }
      chosen.push_back(candidate);
      const double left = error_on(fitted, chosen);
      chosen.pop_back();
      if (left < smallest) {
        smallest = left;
        best = candidate;
      }
    }
    chosen.push_back(best);
    const double now = std::sqrt(error_on(unseen, chosen));
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

double unseen_error(const std::vector<ChargeRecord>& records, std::size_t inputs,
                    const std::vector<double>& rates) {
  const Fit fit =
      fit_with(normal_equations(records, inputs, rates, 0, fitted_share), inputs, all_of(rates));
  const Normal unseen = normal_equations(records, inputs, rates, fitted_share, 1);
  return std::sqrt(std::max(0.0, left_of(unseen, fit.columns, fit.weights) / unseen.square));
}

ChargeFit fit_charges(const std::vector<ChargeRecord>& records, std::size_t inputs,
                      const std::vector<double>& rates) {
  const Fit fit = fit_with(normal_equations(records, inputs, rates), inputs, all_of(rates));
  ChargeFit result{{inputs, {}, {}}, {}};
  const auto m = static_cast<Eigen::Index>(inputs),
             own = m * static_cast<Eigen::Index>(1 + rates.size());
  for (const double sign : {1.0, -1.0}) { // top, bottom
    for (Eigen::Index i = 0; i < own; ++i) {
      (i < m ? result.model.direct : result.model.residue)
          .push_back(fit.weights(i, 0) + sign * fit.weights(i, 1));
    }
  }
  for (Eigen::Index i = own; i < fit.weights.rows(); ++i) {
    result.spread.push_back(fit.weights(i, 0));
  }
  return result;
}

} // namespace ionskin::live
