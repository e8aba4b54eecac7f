// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::handover {

/// Contact at one instant, as a linear combination of solved contact states: forces, strains and
/// areas are sums over the terms with their weights. States are combined at the same cell and mesh
/// index, as the mesh moves with the slider.
struct StateCombination {
  struct Term {
    const mechanics::ContactState* state;
    double weight;
  };
  std::vector<Term> terms;        ///< different states; empty while the slider is detached
  std::array<double, 2> centre{}; ///< position of the slider's centre [m]
  /// Height of the slider's underside above the undeformed top face [m].
  double height = 0;
  std::array<double, 2> drive_force{}; ///< force of a drive on the slider [N]
  /// Position of the underside at each cell, as `mechanics::SteppedInstant::turned`; empty where
  /// the angles of the slider never change.
  std::vector<std::array<double, 3>> turned;

  /// Adds a state with a weight, and does nothing if the state is null or carries no load.
  void add(const mechanics::SharedState& state, double weight);

  double normal_force() const; ///< of the full skin, compression positive [N]
  /// Tangential force on the full skin along x and y [N].
  std::array<double, 2> tangential_force() const;
  /// Moment of the forces on the full skin, as `ContactState::moment` [N m].
  std::array<double, 3> moment() const;
  double contact_area() const;  ///< of the full skin [m2]
  double stick_area() const;    ///< part of the contact area in which nothing slips [m2]
  double peak_pressure() const; ///< largest mean pressure of a cell [Pa]
  /// Uncertainty of the contact area, as only whole cells touch, see `mechanics::border_area` [m2].
  double contact_border() const;
  /// Sums one quantity of the states with their weights, in the unit of the quantity.
  double sum(double mechanics::ContactState::*quantity) const;
};

/// Contact of Study 1 as a function of time within one cycle, interpolated linearly between the
/// instants that the contact solver stored.
class ContactTimeline {
public:
  /// Makes the timeline.
  /// @param input,contact must outlive the timeline
  ContactTimeline(const Case& input, const mechanics::ContactSolution& contact);

  /// Stored instants of one cycle, from 0 to its duration, ascending [s]. The contact is linear
  /// between them.
  const std::vector<double>& sample_times() const { return sample_times_; }
  /// Instants after which currents of the ion transport change fast, such as landing or the begin
  /// of a slide, so that its time steps restart small [s].
  const std::vector<double>& event_times() const { return contact_.stepped_events; }
  /// Instant from which the whole contact slips in the first slide [s]. It is the begin of the
  /// slide if the stroke is 0, and the end of the slide if the contact never slips as a whole.
  double join_time() const;
  /// Intervals from the begin of each slide to the instant from which the whole contact slips [s].
  const std::vector<std::array<double, 2>>& onsets() const { return contact_.stepped_onsets; }

  /// Interpolates the contact at an instant.
  /// @param local_time within one cycle [s]
  StateCombination at(double local_time) const;
  /// Contact at one of the sample instants.
  StateCombination at_sample(std::size_t index) const { return at(sample_times_[index]); }

private:
  const mechanics::ContactSolution& contact_;
  double begin_of_slide_ = 0; ///< begin of the first slide [s]
  std::vector<double> sample_times_;
};

} // namespace ionskin::handover
