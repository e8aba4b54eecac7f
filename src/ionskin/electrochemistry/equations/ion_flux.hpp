// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// B(x) = x / (exp(x) - 1) and its derivative.
struct Bernoulli {
  double value = 0;
  double derivative = 0;
};

Bernoulli bernoulli(double x);

/// Flux of the ions through the thickness between two neighbouring levels, upward positive,
/// docs/model.md (12):
///   J = (B(u) c_lower - B(-u) c_upper) / d,   u = phi_upper - phi_lower,   B(-u) = B(u) + u,
/// exact for a constant flux and field between the levels, so that it stays monotone in double
/// layers (Scharfetter and Gummel 1969, doi 10.1109/T-ED.1969.16566). All scaled, on whole levels
/// at once.
class ThicknessFlux {
public:
  explicit ThicknessFlux(std::size_t columns) : difference_(columns), exponential_(columns) {}

  /// Flux J between two levels, [columns], into `flux`.
  /// @param spacing d between the levels; all spans hold one value per column
  void evaluate(std::span<const double> concentration_lower,
                std::span<const double> concentration_upper,
                std::span<const double> potential_lower, std::span<const double> potential_upper,
                double spacing, std::span<double> flux);

  /// dJ/dc_lower, -dJ/dc_upper and dJ/du per column.
  void derivatives(std::span<const double> concentration_lower,
                   std::span<const double> concentration_upper,
                   std::span<const double> potential_lower, std::span<const double> potential_upper,
                   double spacing, std::span<double> by_lower, std::span<double> by_upper,
                   std::span<double> by_difference);

private:
  template <class Body>
  void for_columns(std::span<const double> potential_lower, std::span<const double> potential_upper,
                   const Body& body);

  std::vector<double> difference_, exponential_; ///< u and, where needed, exp(u) of a level
};

} // namespace ionskin::electrochemistry
