// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <array>
#include <string>
#include <vector>

namespace ionskin {

/// Vertical control of the slider at one instant: its height, or its normal force.
struct SliderLevel {
  bool is_force = false; ///< true if `value` is a force, false if it is a height
  /// Normal force [N], or height of the underside above the undeformed top face [m].
  double value = 0;

  /// True if the slider presses on the skin: the force is above 0, or the height below 0. A slider
  /// that only adhesion holds counts as detached.
  bool touches() const { return is_force ? value > 0 : value < 0; }
  bool operator==(const SliderLevel&) const = default;
};

/// Phase of a cycle, to which every leg of the motion belongs.
enum class Phase { touchdown, slide, lift, return_ };
/// Name of a phase in signals.csv: "touchdown", "slide", "lift" or "return".
std::string name(Phase phase);

/// A piece of a cycle in which position, pose and height or force of the slider change linearly in
/// time. Between a height and a force, the height is linear until the slider carries the force, or
/// from the instant on at which it no longer does.
struct MotionLeg {
  Phase phase = Phase::touchdown;
  double begin = 0;                          ///< since the start of the cycle [s]
  double duration = 0;                       ///< [s]
  std::array<double, 2> from{}, to{};        ///< centre of the slider at start and end, x and y [m]
  SliderLevel from_level, to_level;          ///< height or force at start and end
  shapes::Pose from_pose = {}, to_pose = {}; ///< pose at start and end

  double end() const { return begin + duration; } ///< since the start of the cycle [s]
  double length() const;                          ///< of the path in the x-y plane [m]
  /// Unit vector of the path in the x-y plane; {0, 0} for a leg of length 0.
  std::array<double, 2> direction() const;
  /// Centre of the slider, x and y [m].
  /// @param since_begin time since the start of the leg [s], clamped to its duration
  std::array<double, 2> centre(double since_begin) const;
  /// Pose of the slider.
  /// @param since_begin time since the start of the leg [s], clamped to its duration
  shapes::Pose pose(double since_begin) const;
  /// True if any angle of the slider changes, by a turn or by a tilt.
  bool turns() const { return from_pose != to_pose; }
  /// True if the slider touches the skin at the start or at the end of the leg.
  bool touches() const { return from_level.touches() || to_level.touches(); }
  /// True if the slider is detached at the start and touches at the end.
  bool lands() const { return touches() && !from_level.touches(); }
  /// True if the slider touches at the start and is detached at the end.
  bool leaves() const { return touches() && !to_level.touches(); }
  /// True if the slider moves along the skin in contact.
  bool slides() const { return touches() && length() > 0; }
};

/// The legs of one cycle of any kind of motion, in order of time. The last leg ends with the cycle.
/// @param slider gives the pose and, for strokes, the start of the path
std::vector<MotionLeg> motion_legs(const Motion& motion, const Slider& slider);

/// Resolves the angles of a path through waypoints: fills those that waypoints leave out from
/// `Slider::pose`, sets the pose to that of the first waypoint, and sets `Slider::changing`. Needed
/// before `Slider::underside` is called. Does nothing to other kinds of motion.
void settle_pose(Case& input);

/// The part of a leg in which the slider touches the skin, as `contact_part` finds it.
struct ContactPart {
  double begin = 0, duration = 0;     ///< start, within the leg, and duration [s]
  std::array<double, 2> from{}, to{}; ///< centre of the slider at start and end, x and y [m]
  SliderLevel from_level, to_level;   ///< height or force at start and end
};
/// Cuts a leg that lands or leaves between two heights at the instant at which the underside passes
/// the undeformed top face, docs/model.md (2). Returns any other leg whole.
ContactPart contact_part(const MotionLeg& leg);

/// The smallest rectangle that contains the slider's centre at all times.
struct MotionBox {
  std::array<double, 2> low{}, high{}; ///< least and greatest x and y [m]
};
/// Computes the rectangle in which the slider's centre moves.
MotionBox motion_box(const Motion& motion, const Slider& slider);

/// The leg from which metrics of the slide are taken: the first leg that slides and touches from
/// its start on; else the first leg that touches from its start on; else the first leg that
/// touches; else the first leg. The result refers to `legs`, which must not be empty.
const MotionLeg& first_slide(const std::vector<MotionLeg>& legs);

/// Joins the leg of `first_slide` with the legs that continue the slide, as in a recorded path:
/// they follow without a rest, and the direction turns by at most 0.1 rad from one leg to the next.
/// The result ends with the last of them.
MotionLeg whole_slide(const std::vector<MotionLeg>& legs);
/// Unit vector, x and y, from the start to the end of `whole_slide`; the direction of `first_slide`
/// if the slide leads back, so that its ends are closer than half the length of its path.
std::array<double, 2> slide_direction(const std::vector<MotionLeg>& legs);
/// All legs in order, with each slide and the legs that continue it (see `whole_slide`) joined into
/// one leg.
std::vector<MotionLeg> joined_slides(const std::vector<MotionLeg>& legs);

} // namespace ionskin
