// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/small_signal.hpp"

#include "ionskin/electrochemistry/equations/transport_equations.hpp"
#include "ionskin/electrochemistry/grid/charges.hpp"
#include "ionskin/electrochemistry/grid/transport_grid.hpp"

#include <algorithm>
#include <numbers>

namespace ionskin::electrochemistry {
namespace {

using Complex = std::complex<double>;
using ComplexBlock = std::array<Complex, 4>;
using ComplexPair = std::array<Complex, 2>;

template <class A, class B>
ComplexBlock product(const std::array<A, 4>& a, const std::array<B, 4>& b) {
  return {a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2],
          a[2] * b[1] + a[3] * b[3]};
}

template <class Entry> ComplexPair product(const std::array<Entry, 4>& a, const ComplexPair& x) {
  return {a[0] * x[0] + a[1] * x[1], a[2] * x[0] + a[3] * x[1]};
}

ComplexBlock inverse(const ComplexBlock& a) {
  const Complex determinant = a[0] * a[3] - a[1] * a[2];
  return {a[3] / determinant, -a[1] / determinant, -a[2] / determinant, a[0] / determinant};
}

/// One column of the case's transport grid.
TransportGrid column_grid(const Case& input, double debye_length) {
  const GridResolution resolution =
      refined(grid_resolution(input.numerics.preset), input.numerics.mesh_refinement);
  return {{0.0, input.skin.length},
          {0.0, input.skin.width},
          graded_nodes(input.skin.core_thickness(), debye_length, resolution)};
}

/// Departure from rest as a state: 1 + c, phi.
IonState state_of(const std::vector<ComplexPair>& solution, double (*part)(const Complex&)) {
  IonState state(solution.size());
  for (std::size_t k = 0; k < solution.size(); ++k) {
    state.concentration()[k] = 1.0 + part(solution[k][0]);
    state.potential()[k] = part(solution[k][1]);
  }
  return state;
}

/// Charge of the top electrode, scaled.
Complex top_charge(const ScaledGrid& grid, const std::vector<ComplexPair>& solution) {
  const std::vector<double> fixed_charge(grid.levels, 1.0);
  WallCharges real, imaginary;
  wall_charges(grid, state_of(solution, [](const Complex& z) { return z.real(); }), fixed_charge,
               real);
  wall_charges(grid, state_of(solution, [](const Complex& z) { return z.imag(); }), fixed_charge,
               imaginary);
  return {real.total_top, imaginary.total_top};
}

} // namespace

SmallSignalCell::SmallSignalCell(const Case& input)
    : scales_(derive_scales(input.electrochemistry, input.skin.core_thickness())),
      grid_(column_grid(input, scales_.debye_length)),
      scaled_(scale_grid(grid_, scales_.debye_length)),
      excess_(steric_excess(input.electrochemistry)), lower_(scaled_.levels),
      diagonal_(scaled_.levels), upper_(scaled_.levels) {
  probe_jacobian();
}

/// Every third level at once: a level answers to itself and its neighbours only.
void SmallSignalCell::probe_jacobian() {
  const std::size_t levels = scaled_.levels;
  parallel::WorkerTeam team(1);
  TransportEquations equations(scaled_, team, excess_);
  IonState rest(levels);
  std::ranges::fill(rest.concentration(), 1.0);
  const std::vector<double> start(levels, 1.0), fixed_charge(levels, 1.0);
  equations.linearise({start, 1.0, fixed_charge}, rest);
  std::vector<double> direction(2 * levels), answer(2 * levels);
  for (std::size_t colour = 0; colour < 3; ++colour) {
    for (std::size_t unknown = 0; unknown < 2; ++unknown) {
      std::ranges::fill(direction, 0.0);
      for (std::size_t k = colour; k < levels; k += 3) {
        direction[unknown * levels + k] = 1.0;
      }
      equations.apply_jacobian(direction, answer);
      for (std::size_t k = 0; k < levels; ++k) {
        auto& blocks = k % 3 == colour ? diagonal_ : (k + 1) % 3 == colour ? upper_ : lower_;
        blocks[k][unknown] = answer[k];
        blocks[k][2 + unknown] = answer[levels + k];
      }
    }
  }
}

std::vector<SmallSignalCell::Answer> SmallSignalCell::respond(std::complex<double> rate) const {
  const std::size_t levels = scaled_.levels;
  // A stage of unit step holds height c + (outflow); the oscillation wants rate height c instead.
  std::vector<ComplexBlock> eliminated(levels);
  std::vector<ComplexPair> solution(levels);
  solution.front()[1] = -0.5;
  solution.back()[1] = 0.5;
  for (std::size_t k = 0; k < levels; ++k) {
    ComplexBlock block{diagonal_[k][0] + (rate - 1.0) * scaled_.height[k], diagonal_[k][1],
                       diagonal_[k][2], diagonal_[k][3]};
    if (k > 0) {
      const ComplexPair carried = product(lower_[k], product(eliminated[k - 1], solution[k - 1]));
      const ComplexBlock fill = product(lower_[k], product(eliminated[k - 1], upper_[k - 1]));
      for (std::size_t i = 0; i < 4; ++i) {
        block[i] -= fill[i];
      }
      solution[k][0] -= carried[0];
      solution[k][1] -= carried[1];
    }
    eliminated[k] = inverse(block);
  }
  for (std::size_t k = levels; k-- > 0;) {
    if (k + 1 < levels) {
      const ComplexPair from_above = product(upper_[k], solution[k + 1]);
      solution[k][0] -= from_above[0];
      solution[k][1] -= from_above[1];
    }
    solution[k] = product(eliminated[k], solution[k]);
  }
  return solution;
}

std::complex<double> SmallSignalCell::area_impedance(double frequency) const {
  const Complex angular(0.0, 2.0 * std::numbers::pi * frequency);
  const Complex current = angular * scales_.charge_density *
                          top_charge(scaled_, respond(angular * scales_.relaxation_time));
  return scales_.potential_scale / current;
}

} // namespace ionskin::electrochemistry
