// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <vector>

namespace ionskin::poroelasticity {

/// Load that drives the water of a core whose stress relaxes.
enum class RelaxingLoad {
  strain,   ///< along the skin, of a bent strip
  pressure, ///< on its faces
  water     ///< water that is brought into the core
};

/// A core whose shear modulus relaxes as a Prony series, docs/model.md (76). Moduli are over the
/// swelling modulus M of the first instant. Without times nothing relaxes.
struct Relaxation {
  std::vector<double> times; ///< [s]
  std::vector<double> lost;  ///< by how much G is smaller after each time [1]
  double shear = 0;          ///< G of the first instant [1]
  double shear_share = 0;    ///< dM/dG [1]
  double storage = 0;        ///< M_B [1]
  RelaxingLoad load = RelaxingLoad::strain;

  std::size_t terms() const { return times.size() + 1; }
};

/// Relaxation of the core of a case whose law moves water, under its prescribed load.
Relaxation derive_relaxation(const Case& input);

/// The answer of one mode of the water to a unit step of p_u, of the first instant, as a sum of
/// decays: sum of weight * exp(-rate * time).
struct StepResponse {
  std::vector<double> rate;     ///< [terms] [1/s]
  std::vector<double> pressure; ///< weights of P [terms]
  /// Weights of the undrained pressure that would have let in as much water, P less the swelling
  /// times M, and what it has of p_u directly.
  std::vector<double> undrained;
  double undrained_directly = 0;
};

/// Response of one mode to a step of the load, as a sum of exponentials.
/// @param diffusion rate at which the mode would decay if nothing relaxed, c_v times its curvature
///   [1/s]; infinite at an open wall, where P is 0
StepResponse step_response(const Relaxation& relaxation, double diffusion);

} // namespace ionskin::poroelasticity
