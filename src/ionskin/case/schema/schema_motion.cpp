// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/schema/schema_rows.hpp"

#include "ionskin/case/schema/schema_laws.hpp"
#include "ionskin/case/schema/schema_setters.hpp"
#include "ionskin/laws/friction/friction_law.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace ionskin {

using units::Dimension;

namespace {

// Normalises the direction. One of zero length is stored as {0, 0}, which `check_track` refuses.
void into_direction(CaseDraft& draft, const KeyIndex&, const Value& value) {
  constexpr double shortest = 1e-9;
  const double length = std::hypot(value.numbers[0], value.numbers[1]);
  const double scale = length > shortest ? 1 / length : 0;
  draft.input.motion.direction = {value.numbers[0] * scale, value.numbers[1] * scale};
}

bool goes_through_waypoints(const Case& input) {
  return input.motion.kind == MotionKind::waypoints;
}
bool reciprocates(const Case& input) {
  return input.motion.kind == MotionKind::reciprocating;
}

// Makes the row of one duration of the motion.
SchemaRow duration(const std::string& key, const std::string& help, double Motion::*member) {
  return {.key = key,
          .type = ValueType::quantity,
          .dimension = Dimension::time,
          .range = duration_range,
          .need = Need::when_it_applies,
          .applies = goes_in_strokes,
          .help = help,
          .set = into(&Case::motion, member)};
}

// Makes the row of one distance of the motion.
SchemaRow distance(const std::string& key, const std::string& help, const Range& range,
                   double Motion::*member) {
  return {.key = key,
          .type = ValueType::quantity,
          .dimension = Dimension::length,
          .range = range,
          .need = Need::when_it_applies,
          .applies = goes_in_strokes,
          .help = help,
          .set = into(&Case::motion, member)};
}

// Stores the preload as an indentation or as a force, by the dimension as written.
void into_preload(CaseDraft& draft, const KeyIndex&, const Value& value) {
  const bool force = value.dimension == Dimension::force;
  draft.input.motion.preload = force ? 0 : value.numbers[0];
  draft.input.motion.preload_force = force ? value.numbers[0] : 0;
}

Setter into_waypoint(const std::function<void(Waypoint&, const Value&)>& store_value) {
  return [=](CaseDraft& draft, const KeyIndex& index, const Value& value) {
    store_value(draft.input.motion.waypoints[index.entry], value);
  };
}

bool is_driven(const Case& input) {
  return input.motion.drive.given();
}

void add_drive(SchemaRows& rows) {
  const auto add = [&](const std::string& name, Dimension dimension, const Range& range,
                       const std::string& help, double Drive::*member) -> SchemaRow& {
    rows.push_back({.key = "motion.drive." + name,
                    .type = ValueType::quantity,
                    .dimension = dimension,
                    .range = range,
                    .need = Need::where_known,
                    .help = help,
                    .set = [member](CaseDraft& draft, const KeyIndex&, const Value& value) {
                      draft.input.motion.drive.*member = value.numbers[0];
                    }});
    return rows.back();
  };
  add("stiffness", Dimension::stiffness, {1e-3, 1e9, true, true},
      "Spring along the skin between the path of the motion and the slider; without one the slider "
      "follows the path itself.",
      &Drive::stiffness);
  SchemaRow& damping = add("damping", Dimension::damping, {0.0, 1e6, true, true},
                           "Damper beside that spring.", &Drive::damping);
  damping.need = Need::optional;
  damping.applies = is_driven;
  damping.default_value = "\"0 N s/m\"";
  damping.source = "a spring alone";
  SchemaRow& mass =
      add("mass", Dimension::mass, {0.0, 1e3, true, true},
          "Mass of the slider, of which its inertia along the skin counts.", &Drive::mass);
  mass.need = Need::optional;
  mass.applies = is_driven;
  mass.default_value = "\"0 kg\"";
  mass.source = "a slider in balance at every instant";
}

void add_waypoints(SchemaRows& rows) {
  const auto add = [&](const std::string& name, ValueType type, Dimension dimension,
                       const std::string& help, const Setter& set) -> SchemaRow& {
    rows.push_back({.key = "motion.waypoints[]." + name,
                    .type = type,
                    .dimension = dimension,
                    .need = Need::one_of_several,
                    .applies = goes_through_waypoints,
                    .help = help,
                    .set = set});
    return rows.back();
  };
  SchemaRow& time = add("time", ValueType::quantity, Dimension::time,
                        "Instant of the waypoint since the start of the cycle; the first is 0 s.",
                        into_waypoint([](Waypoint& waypoint, const Value& value) {
                          waypoint.time = value.numbers[0];
                        }));
  time.range = {0.0, 1e7, true, true};
  time.need = Need::when_it_applies;
  SchemaRow& position = add("position", ValueType::quantity_pair, Dimension::length,
                            "Centre of the slider, x and y from the skin's corner.",
                            into_waypoint([](Waypoint& waypoint, const Value& value) {
                              store(value, waypoint.position);
                            }));
  position.range = {-10.0, 10.0, true, true};
  position.need = Need::when_it_applies;
  add("height", ValueType::quantity, Dimension::length,
      "Height of the slider's underside above the undeformed top face; negative when it indents.",
      into_waypoint(
          [](Waypoint& waypoint, const Value& value) { waypoint.height = value.numbers[0]; }))
      .range = {-0.1, 1.0, true, true};
  add("force", ValueType::quantity, Dimension::force,
      "Normal force, in place of a height; above 0 N but under contact.law = \"adhesive\".",
      into_waypoint(
          [](Waypoint& waypoint, const Value& value) { waypoint.force = value.numbers[0]; }))
      .range = {-1e6, 1e6, true, true};
  const auto add_angle = [&](const std::string& name, const Range& range,
                             std::optional<double> Waypoint::*angle) {
    add(name, ValueType::quantity, Dimension::angle,
        fmt::format("Angle of the slider at the waypoint, in place of slider.{}.", name),
        into_waypoint([angle](Waypoint& waypoint, const Value& value) {
          waypoint.*angle = value.numbers[0];
        }))
        .range = range;
    rows.back().range_reason = range.upper == tilt_range.upper ? tilt_reason : "";
    rows.back().need = Need::where_known;
  };
  add_angle("roll", tilt_range, &Waypoint::roll);
  add_angle("pitch", tilt_range, &Waypoint::pitch);
  add_angle("yaw", turn_range, &Waypoint::yaw);
  rows.push_back({.key = "motion.file",
                  .type = ValueType::text,
                  .need = Need::one_of_several,
                  .applies = goes_through_waypoints,
                  .help = "File of waypoints in place of motion.waypoints: columns time, x, y, "
                          "height or force, and angles, with units in the header.",
                  .set = into(&Case::motion, &Motion::file)});
}

} // namespace

void add_motion(SchemaRows& rows) {
  rows.push_back(
      {.key = "motion.kind",
       .type = ValueType::choice,
       .default_value = "\"touch-slide-lift\"",
       .choices = {{"touch-slide-lift"}, {"reciprocating"}, {"waypoints"}},
       .help = "Touchdown, slide in contact, lift-off, detached return; the same with strokes back "
               "and forth; or any path through waypoints.",
       .source = "the paper's cycle",
       .set = into<Motion, MotionKind>(&Case::motion, &Motion::kind,
                                       {{"touch-slide-lift", MotionKind::touch_slide_lift},
                                        {"reciprocating", MotionKind::reciprocating},
                                        {"waypoints", MotionKind::waypoints}})});
  rows.push_back(distance("motion.gap",
                          "Clearance between slider and skin at the start of a cycle.",
                          {0.0, 1.0, true, true}, &Motion::gap));
  rows.push_back({.key = "motion.preload",
                  .type = ValueType::quantity,
                  .dimension = Dimension::length,
                  .other_dimension = Dimension::force,
                  .range = {1e-12, 1e6, true, true},
                  .need = Need::when_it_applies,
                  .applies = goes_in_strokes,
                  .help = "Indentation while sliding, or the normal force that is held instead.",
                  .set = into_preload});
  rows.push_back(distance("motion.stroke", "Length of the slide; zero is a press-and-hold.",
                          {0.0, 10.0, true, true}, &Motion::stroke));
  rows.push_back({.key = "motion.direction",
                  .type = ValueType::number_pair,
                  .range = {-1e6, 1e6, true, true},
                  .applies = goes_in_strokes,
                  .default_value = "[1, 0]",
                  .help = "Direction of the slide in the x-y plane; any length, it is normalised.",
                  .source = "the paper slides along the skin",
                  .set = into_direction});
  rows.push_back(duration("motion.touchdown", "Duration of the descent.", &Motion::touchdown));
  rows.push_back(duration("motion.slide", "Duration of the slide, or of the hold; of one stroke.",
                          &Motion::slide));
  rows.push_back(duration("motion.lift", "Duration of the ascent.", &Motion::lift));
  rows.push_back(duration("motion.return", "Duration of the detached return.", &Motion::return_));
  rows.push_back({.key = "motion.strokes",
                  .type = ValueType::integer,
                  .range = {1, 1000, true, true},
                  .applies = reciprocates,
                  .default_value = "2",
                  .help = "Number of strokes in contact, back and forth, one way each.",
                  .source = "once there and back",
                  .set = into(&Case::motion, &Motion::strokes)});
  rows.push_back({.key = "motion.dwell",
                  .type = ValueType::quantity,
                  .dimension = Dimension::time,
                  .range = {0.0, 1e7, true, true},
                  .applies = reciprocates,
                  .default_value = "\"0 s\"",
                  .help = "Rest of the slider at each reversal.",
                  .source = "no rest",
                  .set = into(&Case::motion, &Motion::dwell)});
  rows.push_back({.key = "motion.cycles",
                  .type = ValueType::integer,
                  .range = {1, 10000, true, true},
                  .default_value = "1",
                  .help = "Number of cycles.",
                  .set = into(&Case::motion, &Motion::cycles)});
  add_waypoints(rows);
  add_drive(rows);
}

void add_contact(SchemaRows& rows) {
  rows.push_back({.key = "contact.law",
                  .type = ValueType::choice,
                  .default_value = "\"coulomb\"",
                  .choices = choices_of(laws::friction_laws()),
                  .help = "Friction law.",
                  .source = "the paper's law",
                  .set = into(&Case::contact, &Contact::law)});
  rows.push_back(
      {.key = "contact.friction",
       .type = ValueType::number,
       .range = {0, 2, true, true},
       .range_reason = "solutions of Coulomb's law need not be unique at large coefficients",
       .need = Need::with_contact,
       .help = "Coefficient of friction between slider and skin.",
       .set = into(&Case::contact, &Contact::friction)});
  add_law_parameters(rows, LawSection{"contact", "law", &Case::contact, &Contact::law},
                     laws::friction_laws(), Need::when_it_applies);
}

} // namespace ionskin
