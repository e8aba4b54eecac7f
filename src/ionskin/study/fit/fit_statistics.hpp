// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ionskin::study {

/// Derivatives of every row of the data by the logarithm of each parameter, [parameter][row].
using Jacobian = std::vector<std::vector<double>>;

/// Factor from an estimate to an end of its interval from which on the data say nothing of it.
inline constexpr double undetermined_factor = 1e6;

/// Statistics of the parameters from residuals and derivatives at the optimum, in linear theory
/// with independent normal errors of one unknown size.
struct FitStatistics {
  std::size_t degrees_of_freedom = 0;
  double residual_deviation = 0; ///< in the unit of the data
  double explained = 0;          ///< share of the data's variance, R^2
  double lag_correlation = 0;    ///< of neighbouring residuals; near 0 when they are noise
  /// Standard error of the logarithm of each parameter; infinite where the data do not tell.
  std::vector<double> log_error;
  double quantile =
      0; ///< of Student's t at 97.5 %: an interval is value exp(-+ quantile log_error)
  std::vector<std::vector<double>> correlation; ///< of the estimates
  /// Ratio of the largest to the least singular value of the derivatives.
  double condition_number = 0;
  /// The combination of log parameters that the data fix worst, of length 1.
  std::vector<double> weakest;
};

/// Statistics of a fit at its optimum.
/// @param values the data
/// @param residuals data minus model, more than there are parameters
FitStatistics fit_statistics(const std::vector<double>& values,
                             const std::vector<double>& residuals, const Jacobian& jacobian);

/// Warnings that a reader must know before using the estimates: parameters that the data cannot
/// tell apart or hardly fix, and residuals that are not noise.
std::vector<std::string> fit_warnings(const FitStatistics& statistics,
                                      const std::vector<std::string>& keys);

} // namespace ionskin::study
