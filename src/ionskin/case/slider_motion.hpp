// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <array>
#include <string>
#include <vector>

namespace ionskin {

/// Height at which the slider stands, or force with which it presses.
struct SliderLevel {
  bool is_force = false;
  double value = 0; ///< underside above the undeformed top face [m], or normal force [N]

  bool touches() const { return is_force ? value > 0 : value < 0; }
  bool operator==(const SliderLevel&) const = default;
};

/// Phases as signals.csv names them.
enum class Phase { touchdown, slide, lift, return_ };
std::string name(Phase phase);

/// A piece of a cycle during which position and level change linearly in time. Between a height and
/// a force, where the position stays, the height is linear until the slider carries the force.
struct MotionLeg {
  Phase phase = Phase::touchdown;
  double begin = 0;                   ///< since the start of the cycle [s]
  double duration = 0;                ///< [s]
  std::array<double, 2> from{}, to{}; ///< centre of the slider [m]
  SliderLevel from_level, to_level;
  shapes::Pose from_pose = {}, to_pose = {};

  double end() const { return begin + duration; }
  double length() const;                                  ///< of the way in the x-y plane [m]
  std::array<double, 2> direction() const;                ///< unit vector; 0 for a leg without way
  std::array<double, 2> centre(double since_begin) const; ///< [m]
  shapes::Pose pose(double since_begin) const;
  bool turns() const { return from_pose != to_pose; } ///< or tilts
  bool touches() const { return from_level.touches() || to_level.touches(); }
  bool lands() const { return touches() && !from_level.touches(); }
  bool leaves() const { return touches() && !to_level.touches(); }
  /// True if the slider moves along the skin in contact.
  bool slides() const { return touches() && length() > 0; }
  /// True if another leg does the same at another time.
  bool repeats(const MotionLeg& other) const;
};

/// One cycle of any kind of motion, in order; the last leg ends where the cycle does.
std::vector<MotionLeg> motion_legs(const Motion& motion, const Slider& slider);

/// Notes in the slider which of its angles the motion changes, which a case must know before its
/// underside is asked for.
void settle_pose(Case& input);

/// The part of a leg between two heights in which the slider touches, docs/model.md (2); of other
/// legs all.
struct ContactPart {
  double begin = 0, duration = 0; ///< within the leg [s]
  std::array<double, 2> from{}, to{};
  SliderLevel from_level, to_level;
};
ContactPart contact_part(const MotionLeg& leg);

/// The smallest rectangle that holds the slider's centre throughout.
struct MotionBox {
  std::array<double, 2> low{}, high{}; ///< [m]
};
MotionBox motion_box(const Motion& motion, const Slider& slider);

/// The leg that figures of the slide are taken from: the first that slides, or else the first that
/// stays in contact, or else the first that touches.
const MotionLeg& first_slide(const std::vector<MotionLeg>& legs);

/// The leg of `first_slide` joined with the legs that carry it on, as the rows of a recorded path
/// do: without a rest and without a turn by more than a tenth of a radian from one to the next. It
/// ends where they do; its direction is theirs together, or the first one's where they lead back.
MotionLeg whole_slide(const std::vector<MotionLeg>& legs);
std::array<double, 2> slide_direction(const std::vector<MotionLeg>& legs);
/// All legs, those that carry on a slide made one with it.
std::vector<MotionLeg> joined_slides(const std::vector<MotionLeg>& legs);

} // namespace ionskin
