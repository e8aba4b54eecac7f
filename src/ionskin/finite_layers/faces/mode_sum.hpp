// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace ionskin::finite_layers {

/// Even or odd: which modes act on two opposite faces alike, or with opposite signs.
enum class Parity { even, odd };

/// Parities that occur: a mirrored load has even ones alone.
std::vector<Parity> parities(bool mirrored);

/// Waves along a face fade up to this many times the wave number up to which they count in full.
inline constexpr double fading_end = 1.5;
/// Share of a wave that counts, falling smoothly. Waves that ended at once would leave ripples
/// along the whole face, and jumps of forces where the place of the slider decides the end.
/// @param full wave number up to which the share is 1 [1/m]
double fading_share(double wave_number, double full);

/// A term of a sum over all modes of one parity.
struct ModeTerm {
  double number = 0; ///< of the mode; not whole where one term stands for many
  double weight = 0;
};

/// Terms that stand for the sum over all n = 0, 2, 4, ... or 1, 3, 5, ... with weights 1 for n = 0
/// and 2 beyond, of what is smooth in n and falls like 1/n^2: one by one up to a number, then an
/// integral over ln n by Gauss points (the sum is its midpoint rule), then the end of 1/n^2.
/// @param one_by_one number up to which
std::vector<ModeTerm> mode_sum(Parity parity, int one_by_one);

} // namespace ionskin::finite_layers
