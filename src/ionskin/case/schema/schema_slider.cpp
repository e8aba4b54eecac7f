// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/schema/schema_laws.hpp"
#include "ionskin/case/schema/schema_rows.hpp"
#include "ionskin/case/schema/schema_setters.hpp"

#include <fmt/format.h>

namespace ionskin {

using units::Dimension;

namespace {

bool needs_size(const Case& input) {
  return !shapes::shape_row(input.slider.shape).has_whole_plan;
}

bool is_soft(const Case& input) {
  return !input.slider.rigid();
}

bool takes_heights(const Case& input) {
  return shapes::shape_row(input.slider.shape).takes_heights;
}

} // namespace

void add_slider(SchemaRows& rows) {
  const auto table = shapes::shapes();
  rows.push_back({.key = "slider.shape",
                  .type = ValueType::choice,
                  .default_value = fmt::format("\"{}\"", table.front().name),
                  .choices = choices_of(table),
                  .help = fmt::format("Shape of the underside of the rigid slider: {}.",
                                      alternatives(table, &shapes::ShapeRow::meaning)),
                  .source = "the paper's slider is a block",
                  .set = into(&Case::slider, &Slider::shape)});
  rows.push_back({.key = "slider.size",
                  .type = ValueType::quantity_pair,
                  .dimension = Dimension::length,
                  .range = extent,
                  .need = Need::when_it_applies,
                  .applies = needs_size,
                  .may_stand = true,
                  .help = "Plan of the slider along x and y; the whole diameter for a sphere "
                          "without one.",
                  .set = into(&Case::slider, &Slider::size)});
  add_law_parameters(rows, LawSection{"slider", "shape", &Case::slider, &Slider::shape}, table,
                     Need::when_it_applies);
  rows.push_back({.key = "slider.profile",
                  .type = ValueType::text,
                  .need = Need::when_it_applies,
                  .applies = takes_heights,
                  .help = "CSV file with the heights of the underside: the unit of length and the "
                          "values of x in its first row, then y and the heights along x in each.",
                  .set = into(&Case::slider, &Slider::profile)});
  rows.push_back(
      {.key = "slider.start",
       .type = ValueType::quantity_pair,
       .dimension = Dimension::length,
       .range = {-10.0, 10.0, true, true},
       .need = Need::when_it_applies,
       .applies = goes_in_strokes,
       .help = "Centre of the slider at the start of a cycle, x and y from the skin's corner.",
       .set = into(&Case::slider, &Slider::start)});
  const auto add_angle = [&](const std::string& key, const Range& range, const std::string& help,
                             double shapes::Pose::*angle) {
    rows.push_back({.key = key,
                    .type = ValueType::quantity,
                    .dimension = Dimension::angle,
                    .range = range,
                    .range_reason = range.upper == tilt_range.upper ? tilt_reason : "",
                    .default_value = "\"0 deg\"",
                    .help = help,
                    .source = "the paper's slider stands upright",
                    .set = [angle](CaseDraft& draft, const KeyIndex&, const Value& value) {
                      draft.input.slider.pose.*angle = value.numbers[0];
                    }});
  };
  add_angle("slider.roll", tilt_range,
            "Tilt about the slider's x axis: above 0 its side at +y rises.", &shapes::Pose::roll);
  add_angle("slider.pitch", tilt_range,
            "Tilt about the slider's y axis: above 0 its end at +x sinks.", &shapes::Pose::pitch);
  add_angle("slider.yaw", turn_range,
            "Turn of the slider, with its tilt, about z, from x towards y.", &shapes::Pose::yaw);
  rows.push_back({.key = "slider.youngs_modulus",
                  .type = ValueType::quantity,
                  .dimension = Dimension::stress,
                  .range = {1e2, 1e13, true, true},
                  .need = Need::where_known,
                  .help = "Young's modulus of a soft slider, such as a finger, which gives like a "
                          "half-space of its material; a slider without one is rigid.",
                  .set = into(&Case::slider, &Slider::youngs_modulus)});
  rows.push_back({.key = "slider.poissons_ratio",
                  .type = ValueType::number,
                  .range = {0.0, 0.5, true, true},
                  .applies = is_soft,
                  .default_value = "0.5",
                  .help = "Poisson's ratio of a soft slider.",
                  .source = "rubber and tissue hardly change their volume",
                  .set = into(&Case::slider, &Slider::poissons_ratio)});
  rows.push_back({.key = "slider.pad_thickness",
                  .type = ValueType::quantity,
                  .dimension = Dimension::length,
                  .range = extent,
                  .need = Need::where_known,
                  .applies = is_soft,
                  .help = "Thickness of a soft slider that is a layer on a rigid body, such as the "
                          "flesh on a bone; without it the material is deep.",
                  .set = into(&Case::slider, &Slider::pad_thickness)});
}

} // namespace ionskin
