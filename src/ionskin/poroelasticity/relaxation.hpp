// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <vector>

namespace ionskin::poroelasticity {

/// Kind of load that drives the water in a core whose stress relaxes.
enum class RelaxingLoad {
  strain,   ///< prescribed strain along the skin, of a bent strip
  pressure, ///< prescribed pressure on the faces
  water     ///< water carried into the core by the ionic current
};

/// Relaxation of the core: its shear modulus G decays as a Prony series, docs/model.md (76). All
/// moduli are divided by the swelling modulus M at the first instant. Empty `times`: no relaxation.
struct Relaxation {
  std::vector<double> times; ///< relaxation times of the branches [s]
  std::vector<double> lost;  ///< loss of G by each branch, once relaxed, over M [1]
  double shear = 0;          ///< G at the first instant, over M [1]
  double shear_share = 0;    ///< derivative dM/dG [1]
  double storage = 0;        ///< M_B over M [1]
  RelaxingLoad load = RelaxingLoad::strain;

  /// Number of decaying terms of each mode of the water: one, and one per branch.
  std::size_t terms() const { return times.size() + 1; }
};

/// Derives the relaxation of the core under the prescribed load of a case whose law moves water.
Relaxation derive_relaxation(const Case& input);

/// Response of one mode of the water to a unit step of p_u (with the moduli of the first instant),
/// as a sum of decaying terms: sum of weight * exp(-rate * time).
struct StepResponse {
  std::vector<double> rate;     ///< decay rates [term] [1/s]
  std::vector<double> pressure; ///< weights of the terms in P [term] [1]
  /// Weights of the terms in the effective undrained pressure, P - M * swelling [term] [1].
  std::vector<double> undrained;
  double undrained_directly = 0; ///< constant part of the effective undrained pressure [1]
};

/// Computes the response of one mode of the water to a unit step of the load.
/// @param diffusion decay rate of the mode without relaxation, c_v times its eigenvalue [1/s];
///   infinite for the mode of an open wall, where P is 0
StepResponse step_response(const Relaxation& relaxation, double diffusion);

} // namespace ionskin::poroelasticity
