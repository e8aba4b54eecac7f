// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/fit/fit_statistics.hpp"

#include <Eigen/Dense>
#include <boost/math/distributions/students_t.hpp>
#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace ionskin::study {
namespace {

// Singular values below this part of the largest count as 0.
constexpr double rank_tolerance = 1e-10;
// Limits above which the user is warned.
constexpr double ill_conditioned = 1e3;     // condition number
constexpr double strong_correlation = 0.95; // correlation of two estimates
constexpr double hardly_determined = 0.5;   // relative half width of an interval
constexpr double noise_deviations = 4;      // lag correlation, in deviations of that of noise
// Share of the variance below which residuals count as rounding of the data and of the solution:
// 1e-4 of a signal, far below the errors of a mesh.
constexpr double negligible_share = 1e-8;

Eigen::VectorXd vector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

Eigen::MatrixXd matrix(const Jacobian& jacobian) {
  Eigen::MatrixXd result(static_cast<Eigen::Index>(jacobian.front().size()),
                         static_cast<Eigen::Index>(jacobian.size()));
  for (std::size_t i = 0; i < jacobian.size(); ++i) {
    result.col(static_cast<Eigen::Index>(i)) = vector(jacobian[i]);
  }
  return result;
}

double lag_correlation(const Eigen::VectorXd& residuals) {
  const Eigen::Index n = residuals.size();
  const double power = residuals.squaredNorm();
  return power > 0 ? residuals.head(n - 1).dot(residuals.tail(n - 1)) / power : 0.0;
}

/// Adds standard errors and correlations from the singular values; a parameter with a part in the
/// null space has an infinite error.
void add_covariance(const Eigen::JacobiSVD<Eigen::MatrixXd>& svd, double deviation,
                    FitStatistics& statistics) {
  const Eigen::VectorXd& singular = svd.singularValues();
  const Eigen::Index n = singular.size();
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd free = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::VectorXd direction = svd.matrixV().col(i);
    if (singular[i] <= rank_tolerance * singular[0]) {
      free += direction.cwiseAbs2();
    } else {
      covariance += direction * direction.transpose() / (singular[i] * singular[i]);
    }
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    statistics.log_error.push_back(free[i] > rank_tolerance
                                       ? std::numeric_limits<double>::infinity()
                                       : deviation * std::sqrt(covariance(i, i)));
    std::vector<double>& row = statistics.correlation.emplace_back();
    for (Eigen::Index j = 0; j < n; ++j) {
      const double scale = std::sqrt(covariance(i, i) * covariance(j, j));
      row.push_back(i == j ? 1.0 : scale > 0 ? covariance(i, j) / scale : 0.0);
    }
  }
}

std::string combination(const FitStatistics& statistics, const std::vector<std::string>& keys) {
  std::string text;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (std::abs(statistics.weakest[i]) > 0.1) {
      const char* how = keys[i].starts_with("data.") ? " by " : "^";
      text +=
          fmt::format("{}{}{}{:.2f}", text.empty() ? "" : " ", keys[i], how, statistics.weakest[i]);
    }
  }
  return text;
}

} // namespace

FitStatistics fit_statistics(const std::vector<double>& values,
                             const std::vector<double>& residuals, const Jacobian& jacobian) {
  const Eigen::VectorXd remainder = vector(residuals), data = vector(values);
  FitStatistics statistics;
  statistics.degrees_of_freedom = residuals.size() - jacobian.size();
  const auto freedom = static_cast<double>(statistics.degrees_of_freedom);
  statistics.residual_deviation = std::sqrt(remainder.squaredNorm() / freedom);
  const double variance = (data.array() - data.mean()).matrix().squaredNorm();
  statistics.explained = variance > 0 ? 1.0 - remainder.squaredNorm() / variance : 0.0;
  statistics.lag_correlation = lag_correlation(remainder);
  statistics.quantile = boost::math::quantile(boost::math::students_t(freedom), 0.975);

  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix(jacobian), Eigen::ComputeThinV);
  const Eigen::Index last = svd.singularValues().size() - 1;
  const double least = svd.singularValues()[last];
  statistics.condition_number =
      least > 0 ? svd.singularValues()[0] / least : std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i <= last; ++i) {
    statistics.weakest.push_back(svd.matrixV()(i, last));
  }
  add_covariance(svd, statistics.residual_deviation, statistics);
  return statistics;
}

std::vector<std::string> fit_warnings(const FitStatistics& statistics,
                                      const std::vector<std::string>& keys) {
  std::vector<std::string> warnings;
  if (keys.size() > 1 && !(statistics.condition_number < ill_conditioned)) {
    warnings.push_back(fmt::format(
        "The data cannot distinguish all free keys{}: {} may change with almost no trace in the "
        "data. Fix one of these keys, or measure something that depends on them otherwise.",
        std::isfinite(statistics.condition_number)
            ? fmt::format(" (condition number {:.2g})", statistics.condition_number)
            : "",
        combination(statistics, keys)));
  }
  for (std::size_t i = 0; i < keys.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (std::abs(statistics.correlation[i][j]) > strong_correlation) {
        warnings.push_back(fmt::format("The estimates of {} and {} are correlated by {:.3f}: their "
                                       "intervals hold together, not one without the other.",
                                       keys[j], keys[i], statistics.correlation[i][j]));
      }
    }
    const double half_width = statistics.quantile * statistics.log_error[i];
    // The interval of a key of the data is no factor, as its coordinate is linear.
    const bool of_data = keys[i].starts_with("data.");
    const double undetermined =
        of_data ? std::numeric_limits<double>::infinity() : std::log(undetermined_factor);
    if (!(half_width < undetermined)) {
      warnings.push_back(
          fmt::format("The data do not fix {}: they say nothing of its size.", keys[i]));
    } else if (!of_data && half_width >= hardly_determined) {
      warnings.push_back(fmt::format("The data hardly fix {}: its 95 % interval spans a factor of "
                                     "{:.3g} either way.",
                                     keys[i], std::exp(half_width)));
    }
  }
  const double rows = static_cast<double>(statistics.degrees_of_freedom + keys.size());
  if (1 - statistics.explained > negligible_share &&
      std::abs(statistics.lag_correlation) > noise_deviations / std::sqrt(rows)) {
    warnings.push_back(fmt::format(
        "Neighbouring residuals are correlated by {:.2f}: they are not noise, the model does not "
        "describe all of the data, and the intervals are too narrow.",
        statistics.lag_correlation));
  }
  return warnings;
}

} // namespace ionskin::study
