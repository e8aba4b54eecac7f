// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace ionskin::finite_layers {

/// Parity of modes between two opposite faces. Even modes act on both faces identically, odd modes
/// with opposite signs.
enum class Parity { even, odd };

/// Lists the parities that occur: only even for a load that is symmetric about the middle, else
/// both.
std::vector<Parity> parities(bool mirrored);

/// Wave number along a face at which waves have faded to 0, over the wave number up to which they
/// count in full [1].
inline constexpr double fading_end = 1.5;
/// Share of a wave along a face, falling smoothly from 1 to 0. An abrupt end of the sum would leave
/// ripples along the whole face, and jumps of forces where the end depends on the slider's
/// position.
/// @param wave_number of the wave [1/m]
/// @param full wave number up to which the share is 1 [1/m]
double fading_share(double wave_number, double full);

/// Term of a sum over all modes of one parity.
struct ModeTerm {
  double number = 0; ///< number of the mode; not an integer where one term stands for many
  double weight = 0;
};

/// Makes terms that approximate the infinite sum over n = 0, 2, 4, ... or n = 1, 3, 5, ..., with
/// weights 1 for n = 0 and 2 for n > 0. The summand must be smooth in n and fall like 1/n^2. Small
/// n are summed singly; an integral over ln n by Gauss points replaces larger n, as the sum is its
/// midpoint rule; the closed form for 1/n^2 ends it.
/// @param one_by_one largest n that is summed singly
std::vector<ModeTerm> mode_sum(Parity parity, int one_by_one);

} // namespace ionskin::finite_layers
