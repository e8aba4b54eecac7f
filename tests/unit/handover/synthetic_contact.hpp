// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace ionskin::handover {

/// A small skin and slider in round numbers.
inline Case small_case() {
  Case input;
  input.skin.length = 15e-3;
  input.skin.width = 2e-3;
  const Material platinum{"platinum", 168e9, 0.38};
  const Material nafion{"nafion", 249e6, 0.49};
  input.skin.layers = {{"bottom", LayerRole::electrode, platinum, 10e-6},
                       {"core", LayerRole::core, nafion, 180e-6},
                       {"top", LayerRole::electrode, platinum, 10e-6}};
  input.slider.size = {3e-3, 1.5e-3};
  input.slider.start = {4.5e-3, 1e-3};
  input.motion.gap = 1e-3;
  input.motion.preload = 1e-6;
  input.motion.stroke = 6e-3;
  input.motion.touchdown = 0.5;
  input.motion.slide = 2;
  input.motion.lift = 0.5;
  input.motion.return_ = 1;
  input.motion.cycles = 2;
  input.contact.friction = 0.3;
  input.numerics.preset = Preset::coarse;
  return input;
}

/// A state whose forces and strains are multiples of `amplitude`; the strain varies over the core.
inline mechanics::ContactState synthetic_state(const mesh::SkinMesh& mesh, double amplitude,
                                               double pattern = 0) {
  mechanics::ContactState state;
  state.indentation = 1e-6 * amplitude;
  state.normal_force = amplitude;
  state.tangential_force = {0.3 * amplitude, 0};
  const auto elements = mesh.elements();
  const auto rows = mesh.core_z();
  state.strain.points = {2 * elements[0], 2 * elements[1], 2 * (rows[1] - rows[0])};
  const std::size_t count =
      state.strain.points[0] * state.strain.points[1] * state.strain.points[2];
  for (std::size_t c = 0; c < 6; ++c) {
    state.strain.component[c].resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      state.strain.component[c][i] =
          1e-3 * amplitude * std::sin(0.01 * static_cast<double>(i * (c + 1)) + pattern);
    }
  }
  return state;
}

inline mechanics::SharedState shared_state(const mesh::SkinMesh& mesh, double amplitude,
                                           double pattern = 0) {
  return std::make_shared<const mechanics::ContactState>(synthetic_state(mesh, amplitude, pattern));
}

/// Appends an instant of the motion.
inline void add_instant(const Case& input, mechanics::ContactSolution& contact, double time,
                        mechanics::SharedState state) {
  const auto legs = motion_legs(input.motion, input.slider);
  const auto leg = std::partition_point(legs.begin(), legs.end() - 1,
                                        [&](const MotionLeg& other) { return other.end() < time; });
  const double part = (time - leg->begin) / leg->duration;
  const double from = leg->from_level.value, to = leg->to_level.value;
  contact.stepped.push_back({time, leg->centre(time - leg->begin),
                             part == 1 ? to : from + part * (to - from), std::move(state)});
}

/// Touchdown to a normal force of 1 N.
inline mechanics::ContactSolution synthetic_press(const Case& input) {
  const mesh::SkinMesh mesh(input);
  mechanics::ContactSolution contact{mesh};
  const double contact_time = 0.5 * 1000.0 / 1001.0;
  add_instant(input, contact, 0, nullptr);
  add_instant(input, contact, contact_time, nullptr);
  add_instant(input, contact, 0.5, shared_state(mesh, 1.0));
  contact.stepped_events = {contact_time, 0.5, 2.5, 2.5 + 0.5 / 1001};
  return contact;
}

/// Lift-off from the end of the slide and the way back; `half_force` is the normal force at half
/// the indentation.
inline void add_lift_off(const Case& input, mechanics::ContactSolution& contact,
                         double half_force) {
  const double duration = 0.5 / 1001; // the preload's part of lift-off
  if (contact.stepped.back().time < 2.5) {
    add_instant(input, contact, 2.5, contact.stepped.back().state);
  }
  add_instant(input, contact, 2.5 + 0.5 * duration, shared_state(contact.mesh, half_force, 0.3));
  add_instant(input, contact, 2.5 + duration, shared_state(contact.mesh, 0.0));
  add_instant(input, contact, 3, nullptr);
  add_instant(input, contact, 4, nullptr);
}

/// Onset states after 1 and 3 um of travel.
inline void add_onset(const Case& input, mechanics::ContactSolution& contact) {
  const double speed = input.motion.stroke / input.motion.slide;
  add_instant(input, contact, 0.5 + 1e-6 / speed, shared_state(contact.mesh, 1.5, 0.1));
  add_instant(input, contact, std::min(2.5, 0.5 + 3e-6 / speed),
              shared_state(contact.mesh, 1.9, 0.2));
  contact.stepped_onsets = {{0.5, std::min(2.5, 0.5 + 5e-6 / speed)}};
}

/// Steady sliding whose normal force is 2 + (s/mm)^2 at the end of the onset and eight places
/// behind it, onset and lift-off states of round numbers.
inline mechanics::ContactSolution synthetic_contact(const Case& input) {
  mechanics::ContactSolution contact = synthetic_press(input);
  add_onset(input, contact);
  for (int i = 0; i < 9; ++i) {
    const double fraction =
                     i == 0 ? 5e-6 / input.motion.stroke : 0.5 * (1 - std::cos(M_PI * i / 8)),
                 s = input.motion.stroke * fraction;
    add_instant(input, contact, 0.5 + input.motion.slide * fraction,
                shared_state(contact.mesh, 2 + s * s * 1e6, 0.3));
  }
  add_lift_off(input, contact, 0.4 * contact.stepped.back().state->normal_force);
  return contact;
}

} // namespace ionskin::handover
