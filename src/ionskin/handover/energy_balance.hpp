// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/handover/contact_timeline.hpp"

#include <vector>

namespace ionskin::handover {

/// Balance of the work that the slider does on the skin in one cycle.
struct EnergyBalance {
  double external_work = 0; ///< of the slider: forces times its displacement [J]
  /// Dissipated: tangential tractions times slip, less what is stored in elastic slip [J].
  double friction_work = 0;
  /// Left at the end of the cycle, with that of elastic slip, less what adhesion binds [J].
  double elastic_energy = 0;
  double adhesion_loss = 0; ///< in jumps of adhesion, on landing and letting go [J]
  /// Error of the balance over the sum of the magnitudes of the slider's work. It holds the error
  /// of the load steps, where cells open and close within one, and the work against the skin's
  /// change along the track, which goes with the convective part of the slip that the model leaves
  /// out.
  double relative_error = 0;
  /// Energy that friction creates, over the same sum. Friction may only take: every cell in every
  /// step of contact, those between the samples among them.
  double creation_error = 0;
  double magnitude = 0; ///< sum of the magnitudes of the slider's work [J]
  double missing = 0;   ///< work that the balance does not find [J]
  double created = 0;   ///< by friction [J]
};

/// Sums over the samples of the timeline by the trapezoidal rule, by which the elastic energy
/// f.C.f/2 is balanced exactly at a fixed position.
EnergyBalance energy_balance(const ContactTimeline& timeline,
                             const mechanics::ContactSolution& contact);

/// Balance of several sliders on one skin, of which each by itself does not have one: they do work
/// on one another.
EnergyBalance energy_balance(const std::vector<EnergyBalance>& of_each);

} // namespace ionskin::handover
