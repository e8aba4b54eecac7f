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

constexpr double regularisation = 1e-10;  // of a column's square
constexpr double fitted_share = 2.0 / 3;  // of the rows; the rest says how many rates are enough
constexpr double negligible_error = 1e-4; // of the charges
constexpr double worthwhile = 0.9;        // error with another rate over that without

/// Normal equations of half the sum and half the difference of both charges by the drive, by it
/// behind every low pass, and by what spreads.
struct Normal {
  Eigen::MatrixXd gram, right; ///< [(1 + rates) inputs + spread][same], [same][2]
  double square = 0;           ///< of all charges
  std::size_t spread = 0;      ///< columns of what spreads
};

/// Normal equations of the rows between two parts of each record.
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
  std::vector<Eigen::Index> columns; ///< columns that were chosen
  Eigen::MatrixXd weights;           ///< [columns][sum, difference]
};

/// Columns of the instantaneous part and of some of the rates.
std::vector<Eigen::Index> columns_of(std::size_t inputs, const std::vector<std::size_t>& rates) {
  std::vector<Eigen::Index> columns;
  for (std::size_t i = 0; i < inputs * (1 + rates.size()); ++i) {
    const std::size_t block = i / inputs == 0 ? 0 : 1 + rates[i / inputs - 1];
    columns.push_back(static_cast<Eigen::Index>(block * inputs + i % inputs));
  }
  return columns;
}

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

/// Square of what weights of some columns leave.
double left_of(const Normal& normal, const std::vector<Eigen::Index>& columns,
               const Eigen::MatrixXd& weights) {
  const Eigen::MatrixXd gram = normal.gram(columns, columns);
  const Eigen::MatrixXd right = normal.right(columns, Eigen::indexing::all);
  return normal.square - 2 * weights.cwiseProduct(right).sum() +
         weights.cwiseProduct(gram * weights).sum();
}

/// Fit in which what spreads is the same on both sides: a part of their sum alone.
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
      const Fit fit = fit_with(fitted, inputs, chosen);
      const double left = left_of(fitted, fit.columns, fit.weights);
      chosen.pop_back();
      if (left < smallest) {
        smallest = left;
        best = candidate;
      }
    }
    chosen.push_back(best);
    const Fit fit = fit_with(fitted, inputs, chosen);
    const double now = std::sqrt(std::max(0.0, left_of(unseen, fit.columns, fit.weights)));
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
