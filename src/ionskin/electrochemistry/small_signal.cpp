// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/small_signal.hpp"

#include "ionskin/electrochemistry/equations/steric_excess.hpp"
#include "ionskin/electrochemistry/grid/transport_grid.hpp"

#include <cstddef>
#include <numbers>
#include <optional>

namespace ionskin::electrochemistry {
namespace {

using Complex = std::complex<double>;

/// Factor by which the grid is finer than that of the preset `fine`.
constexpr double refinement = 3.0;

ScaledGrid column_grid(const Skin& skin, const DerivedScales& scales) {
  const double thickness = skin.core_thickness();
  return scale_grid({{0.0, skin.length},
                     {0.0, skin.width},
                     graded_nodes(thickness, scales.debye_length,
                                  refined(grid_resolution(Preset::fine), refinement))},
                    scales.debye_length, scales.area_ratio);
}

double diffusion_at_rest(const Electrochemistry& electrochemistry) {
  const std::optional<StericExcess> excess = steric_excess(electrochemistry);
  return excess ? 1.0 + excess->slope(1.0) : 1.0;
}

/// Solves a tridiagonal system without pivoting, as its diagonal dominates.
/// @param right_side of every row
std::vector<Complex> solve_tridiagonal(const std::vector<double>& lower,
                                       std::vector<Complex> diagonal,
                                       const std::vector<double>& upper, double right_side) {
  const std::size_t count = diagonal.size();
  std::vector<Complex> solution(count, right_side);
  for (std::size_t k = 1; k < count; ++k) {
    const Complex factor = lower[k] / diagonal[k - 1];
    diagonal[k] -= factor * upper[k - 1];
    solution[k] -= factor * solution[k - 1];
  }
  for (std::size_t k = count; k-- > 0;) {
    if (k + 1 < count) {
      solution[k] -= upper[k] * solution[k + 1];
    }
    solution[k] /= diagonal[k];
  }
  return solution;
}

} // namespace

SmallSignalCell::SmallSignalCell(const Case& input)
    : scales_(derive_scales(input.electrochemistry, input.skin.core_thickness())),
      grid_(column_grid(input.skin, scales_)),
      diffusion_(diffusion_at_rest(input.electrochemistry)), metal_(input) {}

std::complex<double> SmallSignalCell::area_impedance(double frequency) const {
  return metal_.area_impedance(core_impedance(frequency));
}

/// Solves for w, the share of the charge on the metal that the ions have taken away at each
/// interval between levels. The field between levels, less the part that `charge_weights`
/// exchanges, is that of the charge on the metal and of the ions in the volumes up to there. It is
/// 1 - w, the current of the ions is p w, and the ions in a volume are the difference of w across
/// it. The flux between levels then reads
///   (1 + p) w_k - g_k [(w_{k+1} - w_k) / height_{k+1} - (w_k - w_{k-1}) / height_k] = 1,
/// with w = 0 on the metal. Real and imaginary part of w are exact to rounding each. Those of the
/// potential are not: in the core it hardly differs from the potential in a capacitor.
std::complex<double> SmallSignalCell::core_impedance(double frequency) const {
  const Complex rate(0.0, 2.0 * std::numbers::pi * frequency * scales_.relaxation_time);
  const std::size_t intervals = grid_.spacing.size();
  std::vector<double> exchange(intervals), lower(intervals), upper(intervals);
  std::vector<Complex> diagonal(intervals);
  for (std::size_t k = 0; k < intervals; ++k) {
    exchange[k] = diffusion_ / grid_.spacing[k] - grid_.charge_exchange[k];
    lower[k] = -exchange[k] / grid_.height[k];
    upper[k] = -exchange[k] / grid_.height[k + 1];
    diagonal[k] = 1.0 + rate - lower[k] - upper[k];
  }
  const std::vector<Complex> taken = solve_tridiagonal(lower, diagonal, upper, 1.0);
  Complex voltage = 0.0;
  for (std::size_t k = 0; k < intervals; ++k) {
    // Rise of the concentration from level k to k + 1, from the flux between them.
    const Complex rise = (1.0 - (1.0 + rate) * taken[k]) / exchange[k];
    voltage += grid_.spacing[k] * (1.0 - taken[k] + grid_.charge_exchange[k] * rise);
  }
  return scales_.potential_scale * scales_.relaxation_time / scales_.charge_density *
         (voltage / rate);
}

} // namespace ionskin::electrochemistry
