// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Bernoulli function B(x) = x / (exp(x) - 1) and its derivative, at one x.
struct Bernoulli {
  double value = 0;
  double derivative = 0;
};

Bernoulli bernoulli(double x);

/// Flux of the mobile ions through the thickness between two neighbouring z levels, positive
/// upwards, docs/model.md (12):
///   J = (B(u) c_lower - B(-u) c_upper) / d,   u = phi_upper - phi_lower,   B(-u) = B(u) + u,
/// with the Bernoulli function B. The formula is exact for a constant flux and field between the
/// levels, so that it stays monotone in double layers (Scharfetter and Gummel 1969, doi
/// 10.1109/T-ED.1969.16566). All values are scaled; all columns of a level are evaluated at once.
class ThicknessFlux {
public:
  explicit ThicknessFlux(std::size_t columns) : difference_(columns), exponential_(columns) {}

  /// Computes the flux J between two levels in every column. All spans hold one value per column.
  /// @param potential_lower, potential_upper potential that drives the ions, excess included [R
  ///   T/(v F)]
  /// @param spacing d between the levels [Debye lengths]
  /// @param flux receives J
  void evaluate(std::span<const double> concentration_lower,
                std::span<const double> concentration_upper,
                std::span<const double> potential_lower, std::span<const double> potential_upper,
                double spacing, std::span<double> flux);

  /// Computes dJ/dc_lower, -dJ/dc_upper and dJ/du in every column; arguments as for `evaluate`.
  void derivatives(std::span<const double> concentration_lower,
                   std::span<const double> concentration_upper,
                   std::span<const double> potential_lower, std::span<const double> potential_upper,
                   double spacing, std::span<double> by_lower, std::span<double> by_upper,
                   std::span<double> by_difference);

private:
  template <class Body>
  void for_columns(std::span<const double> potential_lower, std::span<const double> potential_upper,
                   const Body& body);

  std::vector<double> difference_, exponential_; ///< u and, where needed, exp(u) of each column
};

} // namespace ionskin::electrochemistry
