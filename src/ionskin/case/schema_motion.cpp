// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/schema_rows.hpp"

#include "ionskin/case/schema_setters.hpp"

#include <cmath>

namespace ionskin {

using units::Dimension;

namespace {

// A direction without length stays so, for check_case to refuse.
void into_direction(CaseDraft& draft, const KeyIndex&, const Value& value) {
  const double length = std::hypot(value.numbers[0], value.numbers[1]);
  const double scale = length > 0 ? 1 / length : 1;
  draft.input.motion.direction = {value.numbers[0] * scale, value.numbers[1] * scale};
}

// One duration of the motion.
SchemaRow duration(const std::string& key, const std::string& help, double Motion::*member) {
  return {.key = key,
          .type = ValueType::quantity,
          .dimension = Dimension::time,
          .range = positive,
          .need = Need::with_contact,
          .help = help,
          .set = into(&Case::motion, member)};
}

// One distance of the motion.
SchemaRow distance(const std::string& key, const std::string& help, const Range& range,
                   double Motion::*member) {
  return {.key = key,
          .type = ValueType::quantity,
          .dimension = Dimension::length,
          .range = range,
          .need = Need::with_contact,
          .help = help,
          .set = into(&Case::motion, member)};
}

// An indentation or a force.
void into_preload(CaseDraft& draft, const KeyIndex&, const Value& value) {
  const bool force = value.dimension == Dimension::force;
  draft.input.motion.preload = force ? 0 : value.numbers[0];
  draft.input.motion.preload_force = force ? value.numbers[0] : 0;
}

} // namespace

void add_slider(SchemaRows& rows) {
  rows.push_back({.key = "slider.shape",
                  .type = ValueType::choice,
                  .default_value = "\"flat\"",
                  .choices = {{"flat"}, {"sphere", false}, {"cylinder", false}, {"profile", false}},
                  .help = "Shape of the underside of the rigid slider; flat has sharp edges.",
                  .source = "the paper's slider is a block",
                  .set = into<Slider, SliderShape>(&Case::slider, &Slider::shape,
                                                   {{"flat", SliderShape::flat}})});
  rows.push_back({.key = "slider.size",
                  .type = ValueType::quantity_pair,
                  .dimension = Dimension::length,
                  .range = positive,
                  .need = Need::with_contact,
                  .help = "Footprint of the slider along x and y.",
                  .set = into(&Case::slider, &Slider::size)});
  rows.push_back(
      {.key = "slider.start",
       .type = ValueType::quantity_pair,
       .dimension = Dimension::length,
       .need = Need::with_contact,
       .help = "Centre of the slider at the start of a cycle, x and y from the skin's corner.",
       .set = into(&Case::slider, &Slider::start)});
}

void add_motion(SchemaRows& rows) {
  rows.push_back(
      {.key = "motion.kind",
       .type = ValueType::choice,
       .default_value = "\"touch-slide-lift\"",
       .choices = {{"touch-slide-lift"}},
       .help = "Touchdown, slide in contact, lift-off, detached return.",
       .source = "the paper's cycle",
       .set = into<Motion, MotionKind>(&Case::motion, &Motion::kind,
                                       {{"touch-slide-lift", MotionKind::touch_slide_lift}})});
  rows.push_back(distance("motion.gap",
                          "Clearance between slider and skin at the start of a cycle.",
                          not_negative, &Motion::gap));
  rows.push_back({.key = "motion.preload",
                  .type = ValueType::quantity,
                  .dimension = Dimension::length,
                  .other_dimension = Dimension::force,
                  .range = positive,
                  .need = Need::with_contact,
                  .help = "Indentation while sliding, or the normal force that is held instead.",
                  .set = into_preload});
  rows.push_back(distance("motion.stroke", "Length of the slide; zero is a press-and-hold.",
                          not_negative, &Motion::stroke));
  rows.push_back({.key = "motion.direction",
                  .type = ValueType::number_pair,
                  .default_value = "[1, 0]",
                  .help = "Direction of the slide in the x-y plane; any length, it is normalised.",
                  .source = "the paper slides along the skin",
                  .set = into_direction});
  rows.push_back(duration("motion.touchdown", "Duration of the descent.", &Motion::touchdown));
  rows.push_back(
      duration("motion.slide", "Duration of the slide, or of the hold.", &Motion::slide));
  rows.push_back(duration("motion.lift", "Duration of the ascent.", &Motion::lift));
  rows.push_back(duration("motion.return", "Duration of the detached return.", &Motion::return_));
  rows.push_back({.key = "motion.cycles",
                  .type = ValueType::integer,
                  .range = {1, 10000, true, true},
                  .default_value = "1",
                  .help = "Number of cycles.",
                  .set = into(&Case::motion, &Motion::cycles)});
}

void add_contact(SchemaRows& rows) {
  rows.push_back({.key = "contact.law",
                  .type = ValueType::choice,
                  .default_value = "\"coulomb\"",
                  .choices = {{"coulomb"}},
                  .help = "Friction law.",
                  .source = "the paper's law",
                  .set = into<Contact, FrictionLaw>(&Case::contact, &Contact::law,
                                                    {{"coulomb", FrictionLaw::coulomb}})});
  rows.push_back(
      {.key = "contact.friction",
       .type = ValueType::number,
       .range = {0, 2, true, true},
       .range_reason = "solutions of Coulomb's law need not be unique at large coefficients",
       .need = Need::with_contact,
       .help = "Coefficient of friction between slider and skin.",
       .set = into(&Case::contact, &Contact::friction)});
}

} // namespace ionskin
