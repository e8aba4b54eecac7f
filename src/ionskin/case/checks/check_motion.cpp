// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/checks/check_motion.hpp"

#include "ionskin/base/files/read_text_file.hpp"
#include "ionskin/case/checks/check_pose.hpp"
#include "ionskin/case/schema/schema.hpp"
#include "ionskin/case/schema/schema_rows.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/case/text/csv_file.hpp"
#include "ionskin/laws/friction/friction_law.hpp"
#include "ionskin/units/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ionskin {

namespace {

constexpr double degrees = 180 / std::numbers::pi;

bool same_position(const Waypoint& a, const Waypoint& b) {
  return a.position == b.position;
}

/// Checks a path through waypoints, one waypoint after another.
class WaypointCheck {
public:
  WaypointCheck(const CaseDocument& document, Problems& problems)
      : document_(document), motion_(document.input.motion), problems_(problems) {}

  bool run() {
    const auto& waypoints = motion_.waypoints;
    if (waypoints.size() < 2) {
      add(fmt::format("a path needs at least two waypoints, and there {} {}",
                      waypoints.size() == 1 ? "is" : "are", waypoints.size()),
          document_.point_at(motion_.file.empty() ? "motion.kind" : "motion.file"),
          "name a file, such as motion.file=path.csv, or write sections [[motion.waypoints]]; "
          "ionskin init FILE --from waypoints writes a case with a path");
      return false;
    }
    for (std::size_t i = 0; i < waypoints.size(); ++i)
      check_one(i);
    if (mistakes_.empty())
      for (std::size_t i = 1; i < waypoints.size(); ++i)
        check_pair(i);
    if (!mistakes_.empty()) {
      add_mistakes();
      return false;
    }
    check_ends();
    return sound_;
  }

private:
  /// Mistakes of one kind.
  struct Mistake {
    std::string message; ///< about the first of them
    std::vector<Pointer> pointers;
    std::string remedy;
    std::size_t count = 0;
  };

  void add(const std::string& message, const std::vector<Pointer>& pointers,
           const std::string& remedy) {
    problems_.add(message, pointers, remedy);
    sound_ = false;
  }

  /// Notes a mistake of waypoint `i`. Waypoints whose mistakes have one remedy are reported
  /// together, as every row of a file may have the same mistake.
  void note(std::size_t i, const std::string& message, const std::string& remedy) {
    const auto known = std::ranges::find(mistakes_, remedy, &Mistake::remedy);
    if (known == mistakes_.end()) {
      mistakes_.push_back({message, point_at_waypoint(document_, i), remedy, 1});
      return;
    }
    constexpr std::size_t most_pointers = 3; // each reads the whole file for its line
    if (++known->count <= most_pointers)
      for (Pointer& pointer : point_at_waypoint(document_, i))
        known->pointers.push_back(std::move(pointer));
  }

  /// Notes a mistake of a waypoint. For waypoints from a file, which may be an unprepared
  /// recording, the remedy also names the command that makes a path of a recording.
  void note_of_recording(std::size_t i, const std::string& message, const std::string& remedy) {
    note(i, message,
         motion_.file.empty() ? remedy
                              : remedy + "; is the file a recording? ionskin motion FILE -o "
                                         "path.csv makes a path of it");
  }

  void add_mistakes() {
    for (const Mistake& mistake : mistakes_) {
      add(mistake.count == 1
              ? mistake.message
              : fmt::format("{} (and {} more of this kind)", mistake.message, mistake.count - 1),
          mistake.pointers, mistake.remedy);
    }
  }

  /// Checks a value of a waypoint against the range of its key. Needed for waypoints from a file;
  /// those in the case are checked when they are read.
  void check_range(std::size_t i, const std::string& name, double value) {
    const SchemaRow& row = *find_row("motion.waypoints[]." + name);
    if (!row.range.contains(value))
      note_of_recording(i,
                        fmt::format("waypoint {}: {} = {} is out of range", i + 1, name,
                                    units::format_si(value, row.dimension)),
                        fmt::format("{} must be {}{}", name, describe(row.range, row.dimension),
                                    name == "time" && motion_.waypoints.front().time > 0
                                        ? "; subtract the time of the first waypoint from all"
                                        : ""));
  }

  void check_one(std::size_t i) {
    const Waypoint& waypoint = motion_.waypoints[i];
    check_range(i, "time", waypoint.time);
    check_range(i, "position", waypoint.position[0]);
    check_range(i, "position", waypoint.position[1]);
    if (waypoint.height)
      check_range(i, "height", *waypoint.height);
    if (waypoint.force)
      check_range(i, "force", *waypoint.force);
    check_range(i, "roll", waypoint.roll.value_or(0));
    check_range(i, "pitch", waypoint.pitch.value_or(0));
    check_range(i, "yaw", waypoint.yaw.value_or(0));
    if (const double tilt = std::hypot(waypoint.roll.value_or(0), waypoint.pitch.value_or(0));
        tilt > steepest_tilt)
      note(i,
           fmt::format("waypoint {}: roll and pitch together tilt the slider by {:.4g} deg", i + 1,
                       tilt * degrees),
           remedy_of_tilt());
    if (waypoint.height.has_value() == waypoint.force.has_value())
      note_of_recording(
          i,
          fmt::format("waypoint {} has {}", i + 1,
                      waypoint.force ? "both a height and a force" : "neither height nor force"),
          "give it one of the two");
    constexpr double least_force = 1e-9; // [N]
    if (waypoint.force && *waypoint.force > 0 && *waypoint.force < least_force)
      note(i, fmt::format("waypoint {}: force = {:.6g} N is out of range", i + 1, *waypoint.force),
           "it must be at least 1e-09 N");
    const bool adheres = laws::friction_law(document_.input.contact.law).adheres;
    if (waypoint.force && *waypoint.force <= 0 && !adheres)
      note_of_recording(
          i,
          fmt::format("waypoint {} has a force of {:.6g} N", i + 1,
                      *waypoint.force + 0.0), // without the sign of -0
          "a force must be above 0 N; a detached slider has a height, and one that pulls needs "
          "contact.law = \"adhesive\"");
    const double thickness = document_.input.skin.thickness();
    if (waypoint.height && -*waypoint.height >= thickness)
      note(i,
           fmt::format("waypoint {} reaches through the skin, which is {:.6g} mm thick: its height "
                       "is {:.6g} mm",
                       i + 1, thickness * 1e3, *waypoint.height * 1e3),
           fmt::format("the height must be above {:.6g} mm", -thickness * 1e3));
  }

  void check_pair(std::size_t i) {
    const Waypoint &before = motion_.waypoints[i - 1], &here = motion_.waypoints[i];
    if (here.time <= before.time)
      note(i,
           fmt::format("waypoint {} at {:.6g} s does not come after waypoint {} at {:.6g} s", i + 1,
                       here.time, i, before.time),
           here.time == before.time
               ? "two places at one time: average them, or drop all rows of that time but one"
               : "the times of waypoints must ascend: sort the rows by time");
  }

  void check_pose(const Waypoint& first, const Waypoint& last) {
    if (motion_.cycles > 1 &&
        (first.roll != last.roll || first.pitch != last.pitch || first.yaw != last.yaw))
      add(fmt::format("motion.cycles = {}, but the slider does not end at the angles that it "
                      "begins with",
                      motion_.cycles),
          point_at_waypoint(document_, motion_.waypoints.size() - 1, "last waypoint"),
          "give the last waypoint the angles of the first, or set motion.cycles = 1");
  }

  void check_ends() {
    const Waypoint &first = motion_.waypoints.front(), &last = motion_.waypoints.back();
    check_pose(first, last);
    if (first.time != 0)
      add(fmt::format("the first waypoint is at {:.6g} s", first.time),
          point_at_waypoint(document_, 0), "the first waypoint must be at 0 s");
    if (first.height.value_or(-1) < 0)
      add("the slider touches the skin from the start", point_at_waypoint(document_, 0),
          "the first waypoint must have a height of at least 0 m; a CSV file may have both "
          "columns, "
          "height and force, one of them empty in each row");
    if (motion_.cycles > 1 && (!same_position(first, last) || last.height.value_or(-1) < 0))
      add(fmt::format("motion.cycles = {}, but the path does not end where it begins, detached",
                      motion_.cycles),
          point_at_waypoint(document_, motion_.waypoints.size() - 1, "last waypoint"),
          "give the last waypoint the position of the first and a height of at least 0 m, or set "
          "motion.cycles = 1");
  }

  const CaseDocument& document_;
  const Motion& motion_;
  Problems& problems_;
  std::vector<Mistake> mistakes_; ///< in the order in which they are found
  bool sound_ = true;
};

std::string kind_name(MotionKind kind) {
  switch (kind) {
  case MotionKind::touch_slide_lift:
    return "touch-slide-lift";
  case MotionKind::reciprocating:
    return "reciprocating";
  case MotionKind::waypoints:
    break;
  }
  return "waypoints";
}

/// Refuses keys that have no effect on this kind of motion: the user would expect one.
void check_kind(const CaseDocument& document, Problems& problems) {
  for (const SchemaRow& row : schema()) {
    const bool of_motion = row.key.starts_with("motion.") || row.key == "slider.start";
    if (!of_motion || row.key.starts_with("motion.drive.") || !row.applies ||
        row.applies(document.input))
      continue;
    const std::size_t wildcard = row.key.find("[]");
    const std::string key = wildcard == std::string::npos ? row.key
                                                          : row.key.substr(0, wildcard) + "[0]" +
                                                                row.key.substr(wildcard + 2);
    const ValueRecord* record = document.find(key);
    if (record != nullptr && record->origin != ValueOrigin::default_value)
      problems.add(fmt::format("{} has no effect with motion.kind = \"{}\"", key,
                               kind_name(document.input.motion.kind)),
                   document.point_at(key), "remove it, or choose another motion.kind");
  }
}

} // namespace

std::vector<Pointer> point_at_waypoint(const CaseDocument& document, std::size_t index,
                                       const std::string& note) {
  const Motion& motion = document.input.motion;
  const std::size_t line = motion.waypoints[index].line;
  if (line == 0)
    return document.point_at(fmt::format("motion.waypoints[{}].time", index), note);
  // Reading the whole file again for each message is acceptable: there are only a few messages.
  const std::string text = csv_line(base::read_text_file(motion.file, "waypoint"), line);
  return {{{motion.file, line, 1, text.size(), text}, note}};
}

bool check_motion(const CaseDocument& document, Problems& problems) {
  check_kind(document, problems);
  const Motion& motion = document.input.motion;
  if (motion.kind != MotionKind::waypoints)
    return true;
  if (!motion.file.empty() && document.find("motion.waypoints[0].time") != nullptr) {
    problems.add("the path is given twice", document.point_at("motion.file"),
                 "keep either motion.file or the sections [[motion.waypoints]]");
    return false;
  }
  return WaypointCheck(document, problems).run();
}

} // namespace ionskin
