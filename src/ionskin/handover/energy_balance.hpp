// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/handover/contact_timeline.hpp"

#include <vector>

namespace ionskin::handover {

/// Energy balance of the contact over one cycle, calculated by `energy_balance` for the full skin.
struct EnergyBalance {
  double external_work = 0; ///< work of the slider: forces times its displacement [J]
  /// Dissipated energy: tangential forces times slip, without the energy stored in elastic slip
  /// [J].
  double friction_work = 0;
  /// Elastic energy left at the end of the cycle, including elastic slip, minus the energy that
  /// adhesion binds [J].
  double elastic_energy = 0;
  double adhesion_loss = 0; ///< energy lost in jumps of adhesion, on landing and letting go [J]
  /// Absolute error of the balance, `missing` over `magnitude` [1]. It contains the error of the
  /// load steps, as cells open and close within a step, and the work against the change of the skin
  /// along the track, which belongs to the convective part of the slip that the model neglects.
  double relative_error = 0;
  /// Energy that friction creates, `created` over `magnitude` [1]. Friction may only dissipate; the
  /// sum goes over every cell in every step of the contact solver, also those between the samples.
  double creation_error = 0;
  double magnitude = 0; ///< sum of the absolute work of the slider in each interval [J]
  double missing = 0;   ///< work that is in none of the other terms [J]
  double created = 0;   ///< energy that friction creates, where it should dissipate [J]
};

/// Calculates the balance by the trapezoidal rule over the samples of the timeline. For a slider at
/// a fixed position this rule balances the elastic energy f.C.f/2 exactly.
EnergyBalance energy_balance(const ContactTimeline& timeline,
                             const mechanics::ContactSolution& contact);

/// Sums the balances of several sliders on one skin. A single slider has no closed balance, as
/// sliders do work on one another through the skin.
EnergyBalance energy_balance(const std::vector<EnergyBalance>& of_each);

} // namespace ionskin::handover
