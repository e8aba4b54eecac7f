// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <cmath>
#include <optional>
#include <span>

namespace ionskin::electrochemistry {

/// Ion model `steric`: ions of finite size on a lattice of N_A c_max sites. A cation of
/// concentration c has the excess chemical potential
///   mu = -ln(1 - c/c_max)   [k T],
/// docs/model.md (15), so that its flux is J = -D (grad c + (v F / R T) c grad phi + c grad mu) and
/// c stays below c_max (Bikerman 1942, doi 10.1080/14786444208520813; Kilic, Bazant and Ajdari
/// 2007, doi 10.1103/PhysRevE.75.021503). The excess acts as a potential does: both drive the flux
/// as the sum psi = phi + mu, wherever the dilute flux has phi. Scaled: c is over c0/v, phi over R
/// T/(v F).
struct StericExcess {
  double filling = 0; ///< c0/(v c_max): the share of the sites that the ions at rest take, below 1

  /// Free share of the sites.
  double room(double concentration) const { return 1.0 - filling * concentration; }
  /// mu, and its derivative by the concentration.
  double excess(double concentration) const { return -std::log1p(-filling * concentration); }
  double slope(double concentration) const { return filling / room(concentration); }

  /// psi = phi + mu per node.
  void drive(std::span<const double> concentration, std::span<const double> potential,
             std::span<double> out) const;
  /// Change of psi with a change of concentration and potential about a state.
  void drive_change(std::span<const double> concentration, std::span<const double> d_concentration,
                    std::span<const double> d_potential, std::span<double> out) const;

  /// True if every node of `guess` has more than a share of the room that it has in `safe`.
  bool leaves_room(std::span<const double> safe, std::span<const double> guess, double share) const;
  /// Shortens changes so that no node loses more than all but a share of its room.
  void keep_room(std::span<const double> before, std::span<double> after, double share) const;
};

/// The excess of a case, or nothing for `dilute`.
std::optional<StericExcess> steric_excess(const Electrochemistry& electrochemistry);

} // namespace ionskin::electrochemistry
