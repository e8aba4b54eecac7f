// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/plane/wave_split.hpp"

#include <boost/math/special_functions/gamma.hpp>

#include <cmath>

namespace ionskin::finite_layers {
namespace {

/// Number of terms in the share of the long waves; the share of the short waves begins like x^(2
/// order).
constexpr int order = 8;

} // namespace

WaveSplit::WaveSplit(double reach, double tolerance)
    : reach_(reach), kappa_(std::sqrt(boost::math::gamma_q_inv(order, tolerance)) / reach),
      last_long_(2 * kappa_ * kappa_ * reach) {}

WaveSplit WaveSplit::all_short(double reach) {
  WaveSplit split;
  split.reach_ = reach;
  return split;
}

WaveSplit WaveSplit::shorter(double factor) const {
  WaveSplit split;
  split.reach_ = reach_ / factor;
  split.kappa_ = kappa_ * factor;
  split.last_long_ = last_long_ * factor;
  return split;
}

double WaveSplit::long_share(double wave_number) const {
  if (kappa_ == 0) {
    return 0;
  }
  const double x = wave_number / (2 * kappa_), square = x * x;
  double sum = 1; // sum of square^i / i! over i < order
  for (int i = order - 1; i > 0; --i) {
    sum = 1 + square / i * sum;
  }
  return std::exp(-square) * sum;
}

} // namespace ionskin::finite_layers
