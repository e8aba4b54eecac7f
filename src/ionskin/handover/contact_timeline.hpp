// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::handover {

/// A linear combination of contact states at fixed mesh index: the mechanics at one instant.
struct StateCombination {
  struct Term {
    const mechanics::ContactState* state;
    double weight;
  };
  std::vector<Term> terms;             ///< of different states; empty while the slider is detached
  std::array<double, 2> centre{};      ///< of the slider [m]
  double height = 0;                   ///< of its underside above the undeformed top face [m]
  std::array<double, 2> drive_force{}; ///< of a drive on the slider [N]
  /// Underside at each cell, see mechanics::SteppedInstant; empty where the angles never change.
  std::vector<std::array<double, 3>> turned;

  /// Adds a share of a state; nothing for no state and for one without load.
  void add(const mechanics::SharedState& state, double weight);

  double normal_force() const;                    ///< of the full skin [N]
  std::array<double, 2> tangential_force() const; ///< on the skin [N]
  std::array<double, 3> moment() const; ///< of the forces on the skin, as ContactState [N m]
  double contact_area() const;          ///< of the full skin [m2]
  double stick_area() const;            ///< of it, where nothing slips [m2]
  double peak_pressure() const;         ///< mean over the cell where it is largest [Pa]
  double contact_border() const;        ///< in doubt, see mechanics::border_area [m2]
  double sum(double mechanics::ContactState::*quantity) const;
};

/// The path of Study 1 on the time axis of one cycle: linear between the instants that were kept.
class ContactTimeline {
public:
  /// @param input, contact must outlive the timeline
  ContactTimeline(const Case& input, const mechanics::ContactSolution& contact);

  /// Sample instants of one cycle from 0 to its duration [s]; the path is linear between them.
  const std::vector<double>& sample_times() const { return sample_times_; }
  /// Instants after which the ion transport has a fresh fast transient [s].
  const std::vector<double>& event_times() const { return contact_.stepped_events; }
  /// Instant from which all of the contact slips its way in the first slide [s]; the begin of the
  /// slide for a zero stroke, its end when it never slides fully.
  double join_time() const;
  /// Spans from the beginning of each slide to where all of the contact slips its way [s].
  const std::vector<std::array<double, 2>>& onsets() const { return contact_.stepped_onsets; }

  /// States of the contact around an instant, with their weights.
  /// @param local_time within one cycle [s]
  StateCombination at(double local_time) const;
  StateCombination at_sample(std::size_t index) const { return at(sample_times_[index]); }

private:
  const mechanics::ContactSolution& contact_;
  double begin_of_slide_ = 0; ///< [s]
  std::vector<double> sample_times_;
};

} // namespace ionskin::handover
