// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <cmath>
#include <optional>
#include <span>

namespace ionskin::electrochemistry {

/// Excess chemical potential of ions of finite size, the ion model `steric`: a lattice of N_A c_max
/// sites. A cation of concentration c has the excess
///   mu = -ln(1 - c/c_max)   [k T],
/// docs/model.md (15), so that its flux is J = -D (grad c + (v F / R T) c grad phi + c grad mu) and
/// c stays below c_max (Bikerman 1942, doi 10.1080/14786444208520813; Kilic, Bazant and Ajdari
/// 2007, doi 10.1103/PhysRevE.75.021503). The excess acts as a potential does: the sum psi = phi +
/// mu drives the flux wherever phi drives dilute ions. In all functions c is in units of c0/v, phi
/// and mu in R T/(v F).
struct StericExcess {
  double filling = 0; ///< c0/(v c_max), share of the sites that ions at rest take, below 1

  /// Free share of the sites at a concentration.
  double room(double concentration) const { return 1.0 - filling * concentration; }
  /// Excess mu at a concentration, and its derivative by the concentration.
  double excess(double concentration) const { return -std::log1p(-filling * concentration); }
  double slope(double concentration) const { return filling / room(concentration); }

  /// Computes psi = phi + mu at every node into `out`.
  void drive(std::span<const double> concentration, std::span<const double> potential,
             std::span<double> out) const;
  /// Computes the change of psi with a change of concentration and potential about a state, per
  /// node, into `out`.
  void drive_change(std::span<const double> concentration, std::span<const double> d_concentration,
                    std::span<const double> d_potential, std::span<double> out) const;

  /// True if the free share of the sites at every node of `guess` is more than `share` times that
  /// in `safe`.
  bool leaves_room(std::span<const double> safe, std::span<const double> guess, double share) const;
  /// Limits the concentrations `after` so that every node keeps at least `share` of the free sites
  /// that it has in `before`.
  void keep_room(std::span<const double> before, std::span<double> after, double share) const;
};

/// Makes the steric excess of a case; nothing unless the ion model is `steric`.
std::optional<StericExcess> steric_excess(const Electrochemistry& electrochemistry);

} // namespace ionskin::electrochemistry
