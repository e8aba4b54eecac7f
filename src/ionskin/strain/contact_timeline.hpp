// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/contact_solution.hpp"

#include <array>
#include <vector>

namespace ionskin::strain {

/// A linear combination of contact states at fixed mesh index: the mechanics at one instant.
struct StateCombination {
  struct Term {
    const mechanics::ContactState* state;
    double weight;
  };
  std::vector<Term> terms; ///< empty while the slider is detached
  double arc_length = 0;   ///< of the slider along its track [m]

  double normal_force() const;                    ///< of the full skin [N]
  std::array<double, 2> tangential_force() const; ///< on the skin [N]
};

/// Puts the path of Study 1 on the time axis of one cycle.
///
/// During onset the state is that of steady sliding at the slider's position plus the deviation of
/// the onset state from steady sliding at the start. The deviation vanishes linearly behind the
/// last onset state, so onset joins steady sliding without a jump: a jump would be a false current.
class ContactTimeline {
public:
  /// @param input, contact must outlive the timeline
  ContactTimeline(const Case& input, const mechanics::ContactSolution& contact);

  /// Sample instants of one cycle from 0 to its duration [s]; the path is linear between them
  /// except in steady sliding, where they are as dense as the preset asks.
  const std::vector<double>& sample_times() const { return sample_times_; }
  /// Those of them after which the ion transport has a fresh fast transient [s].
  const std::vector<double>& event_times() const { return event_times_; }
  /// Instant at which onset has joined steady sliding [s]; the start of the slide for a zero
  /// stroke.
  double join_time() const { return join_time_; }

  /// @param local_time within one cycle [s]
  StateCombination at(double local_time) const;

private:
  /// The middle of the slide and the instants of field output become samples: figures are read
  /// there.
  void add_requested_instants();
  /// Linear between touchdown, the states of onset and the join with steady sliding.
  void add_onset(StateCombination& combination, double travel) const;
  const mechanics::ContactState& end_of_slide() const;
  StateCombination sliding(double travel) const;
  StateCombination lifting(double fraction) const;

  const Case& input_;
  const mechanics::ContactSolution& contact_;
  double contact_time_ = 0;
  double release_time_ = 0;
  double join_travel_ = 0;
  double join_time_ = 0;
  std::vector<double> sample_times_, event_times_;
};

} // namespace ionskin::strain
