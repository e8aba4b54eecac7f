// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/schema/schema_rows.hpp"

#include "ionskin/case/schema/schema_setters.hpp"

namespace ionskin {

using units::Dimension;

namespace {

bool is_round(const Case& input) {
  return input.slider.shape == SliderShape::cylinder || input.slider.shape == SliderShape::sphere;
}

bool needs_size(const Case& input) {
  return input.slider.shape != SliderShape::sphere;
}

bool has_profile(const Case& input) {
  return input.slider.shape == SliderShape::profile;
}

} // namespace

void add_slider(SchemaRows& rows) {
  rows.push_back(
      {.key = "slider.shape",
       .type = ValueType::choice,
       .default_value = "\"flat\"",
       .choices = {{"flat"}, {"cylinder"}, {"sphere"}, {"profile"}},
       .help = "Shape of the underside of the rigid slider; the axis of a cylinder lies along y.",
       .source = "the paper's slider is a block",
       .set = into<Slider, SliderShape>(&Case::slider, &Slider::shape,
                                        {{"flat", SliderShape::flat},
                                         {"cylinder", SliderShape::cylinder},
                                         {"sphere", SliderShape::sphere},
                                         {"profile", SliderShape::profile}})});
  rows.push_back({.key = "slider.size",
                  .type = ValueType::quantity_pair,
                  .dimension = Dimension::length,
                  .range = extent,
                  .need = Need::when_it_applies,
                  .applies = needs_size,
                  .help = "Plan of the slider along x and y; the whole diameter for a sphere "
                          "without one.",
                  .set = into(&Case::slider, &Slider::size)});
  rows.push_back({.key = "slider.edge_radius",
                  .type = ValueType::quantity,
                  .dimension = Dimension::length,
                  .range = {0.0, 1.0, true, true},
                  .default_value = "\"0 mm\"",
                  .help = "Radius of the rounded edges of a flat slider; zero leaves them sharp.",
                  .source = "the paper's slider is a block",
                  .set = into(&Case::slider, &Slider::edge_radius)});
  rows.push_back({.key = "slider.radius",
                  .type = ValueType::quantity,
                  .dimension = Dimension::length,
                  .range = {1e-6, 1e3, true, true},
                  .need = Need::when_it_applies,
                  .applies = is_round,
                  .help = "Radius of a cylinder or sphere.",
                  .set = into(&Case::slider, &Slider::radius)});
  rows.push_back({.key = "slider.profile",
                  .type = ValueType::text,
                  .need = Need::when_it_applies,
                  .applies = has_profile,
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
}

} // namespace ionskin
