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

  /// Adds a share of a state; nothing for no state and for one without load.
  void add(const mechanics::SharedState& state, double weight);

  double normal_force() const;                    ///< of the full skin [N]
  std::array<double, 2> tangential_force() const; ///< on the skin [N]
  double contact_area() const;                    ///< of the full skin [m2]
  double stick_area() const;                      ///< of it, where nothing slips [m2]
  double contact_border() const;                  ///< in doubt, see mechanics::border_area [m2]
  double sum(double mechanics::ContactState::*quantity) const;
};

/// Puts the path of Study 1 on the time axis of one cycle: linear between the load steps of a path,
/// polynomial through the nodes of steady sliding (see mechanics::LegSolution); linear throughout
/// where the motion is stepped.
class ContactTimeline {
public:
  /// @param input, contact must outlive the timeline
  ContactTimeline(const Case& input, const mechanics::ContactSolution& contact);

  /// Sample instants of one cycle from 0 to its duration [s]; the path is linear between them
  /// except in steady sliding, where they are as dense as the preset asks.
  const std::vector<double>& sample_times() const { return sample_times_; }
  /// Those of them after which the ion transport has a fresh fast transient [s].
  const std::vector<double>& event_times() const { return event_times_; }
  /// Instant at which the onset of the first slide has joined steady sliding [s]; the begin of the
  /// slide for a zero stroke, its end when it never slides fully.
  double join_time() const;
  /// From the begin of each slide to where its onset has joined steady sliding [s].
  std::vector<std::array<double, 2>> onsets() const;

  /// @param local_time within one cycle [s]
  StateCombination at(double local_time) const;
  /// The same at a sample; samples at the same point of legs that repeat each other give the very
  /// same combination.
  StateCombination at_sample(std::size_t index) const;

private:
  struct Sample {
    std::size_t leg = 0;
    double since_begin = 0; ///< [s]
  };
  /// Of a motion that is stepped.
  StateCombination between_steps(double local_time) const;
  void add_leg_samples(const Case& input, std::size_t leg);
  void add_sample(std::size_t leg, double since_begin);
  /// The middle of the slide and the instants of field output become samples: figures are read
  /// there.
  void add_requested_instants(const std::vector<double>& fields);
  void sort_samples();
  std::size_t leg_at(double local_time) const;
  StateCombination combination(std::size_t leg, double since_begin) const;
  double height(std::size_t leg, double since_begin, const StateCombination& combination) const;
  double joined_at(std::size_t leg) const;

  const mechanics::ContactSolution& contact_;
  std::vector<MotionLeg> legs_;
  double duration_ = 0;
  std::vector<Sample> samples_;
  std::vector<double> sample_times_, event_times_;
};

} // namespace ionskin::handover
