// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::finite_layers {

/// Split of a compliance into short waves, whose response ends within a reach of their force, and
/// long waves, which are few and feel the ends and sides of the skin. The share of the long waves
/// is exp(-x^2) (1 + x^2 + ... + x^14/7!) with x = k/(2 kappa), docs/model.md (52). The response of
/// the short waves then falls like exp(-(kappa r)^2). Their share begins like x^16, so that it
/// holds nothing of the slow decay of a bent film. Sums over point charges are split in the same
/// way (Ewald 1921, DOI 10.1002/andp.19213690304).
class WaveSplit {
public:
  /// Chooses kappa and the largest wave number of the long waves.
  /// @param reach of the short waves [m]
  /// @param tolerance relative size at which either share is neglected [1]
  WaveSplit(double reach, double tolerance);
  /// Makes a split without long waves, for a body whose response ends within the reach by itself.
  /// @param reach [m]
  static WaveSplit all_short(double reach);
  /// Makes the split whose short waves are shorter and reach less far by a factor.
  /// @param factor > 1
  WaveSplit shorter(double factor) const;

  /// Share of the short waves at a wave number [1/m], from 0 to 1.
  double short_share(double wave_number) const { return 1 - long_share(wave_number); }
  /// Share of the long waves at a wave number [1/m], from 0 to 1.
  double long_share(double wave_number) const;
  double reach() const { return reach_; }         ///< distance at which short waves end [m]
  double last_long() const { return last_long_; } ///< largest wave number of long waves [1/m]

private:
  WaveSplit() = default;

  double reach_ = 0, kappa_ = 0, last_long_ = 0;
};

} // namespace ionskin::finite_layers
