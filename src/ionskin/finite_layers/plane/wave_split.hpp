// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::finite_layers {

/// Divides the waves of a compliance in two: short ones, whose response ends within a reach of
/// their force, and long ones, which are few and see the ends and sides of the skin. The share of
/// the long ones is exp(-x^2) (1 + x^2 + ... + x^14/7!) with x = k/(2 kappa), docs/model.md (52):
/// the response of the short ones falls like exp(-(kappa r)^2), and they begin like x^16, so that
/// the slower decay of a bent film is not in them. Sums of point charges are divided alike (Ewald
/// 1921, DOI 10.1002/andp.19213690304).
class WaveSplit {
public:
  /// @param reach of the short waves [m]
  /// @param tolerance of either share where it is left out, relative
  WaveSplit(double reach, double tolerance);
  /// None are long: of a body whose response ends within the reach by itself [m].
  static WaveSplit all_short(double reach);

  double short_share(double wave_number) const { return 1 - long_share(wave_number); }
  double long_share(double wave_number) const;
  double reach() const { return reach_; }         ///< of short waves [m]
  double last_long() const { return last_long_; } ///< wave number [1/m]

private:
  WaveSplit() = default;

  double reach_ = 0, kappa_ = 0, last_long_ = 0;
};

} // namespace ionskin::finite_layers
