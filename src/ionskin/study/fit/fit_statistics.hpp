// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ionskin::study {

/// Derivatives of the prediction at every row of the data by the coordinate of each parameter (the
/// logarithm of a key of the case), [parameter][row].
using Jacobian = std::vector<std::vector<double>>;

/// Factor between an estimate and an end of its confidence interval from which on the data are
/// taken to say nothing of the parameter [1].
inline constexpr double undetermined_factor = 1e6;

/// Statistics of a least squares fit from residuals and derivatives at the optimum, by linear
/// theory with independent normal errors of one unknown variance. Made by `fit_statistics`.
struct FitStatistics {
  std::size_t degrees_of_freedom = 0;
  /// Root mean square of the residuals per degree of freedom [unit of the data].
  double residual_deviation = 0;
  double explained = 0; ///< explained share of the data's variance, R^2 [1]
  /// Correlation of neighbouring residuals [1]; near 0 when they are noise.
  double lag_correlation = 0;
  /// Standard error of each parameter in its coordinate, the logarithm for a key of the case;
  /// infinite where the data do not determine it.
  std::vector<double> log_error;
  /// Quantile of Student's t at 97.5 %: the 95 % interval of a key of the case is value exp(-+
  /// quantile log_error).
  double quantile = 0;
  std::vector<std::vector<double>> correlation; ///< correlation matrix of the estimates
  /// Condition number of the derivatives, the ratio of their largest to their smallest singular
  /// value.
  double condition_number = 0;
  /// Combination of the parameters' coordinates that the data determine worst, a vector of length
  /// 1.
  std::vector<double> weakest;
};

/// Computes the statistics of a fit at its optimum.
/// @param values the data
/// @param residuals data minus model; more rows than there are parameters
/// @param jacobian derivatives at the optimum
FitStatistics fit_statistics(const std::vector<double>& values,
                             const std::vector<double>& residuals, const Jacobian& jacobian);

/// Warnings for the user of the estimates, one sentence each: parameters that the data cannot
/// distinguish or hardly determine, and residuals that are not noise.
/// @param keys names of the parameters
std::vector<std::string> fit_warnings(const FitStatistics& statistics,
                                      const std::vector<std::string>& keys);

} // namespace ionskin::study
