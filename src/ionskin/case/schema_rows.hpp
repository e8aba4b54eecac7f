// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/coupling.hpp"
#include "ionskin/case/schema.hpp"

#include <limits>
#include <vector>

namespace ionskin {

// The rows of the schema, section by section, in the order of the reference page.

using SchemaRows = std::vector<SchemaRow>;

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr Range positive{0.0, infinity, false, false};
inline constexpr Range not_negative{0.0, infinity, true, false};

/// Whether the motion starts at slider.start; waypoints bring their own places.
inline bool goes_in_strokes(const Case& input) {
  return input.motion.kind != MotionKind::waypoints;
}

/// Whether the coupling law has the coefficient k and a measure of shear.
inline bool has_coupling_coefficient(const Case& input) {
  return !moves_water(input);
}

void add_skin(SchemaRows& rows);
void add_layers(SchemaRows& rows);
void add_materials(SchemaRows& rows);
/// What a material says of the ions in it: the rows of `add_electrochemistry` that may come from
/// it.
void add_ions_of_materials(SchemaRows& rows);
void add_slider(SchemaRows& rows);
void add_motion(SchemaRows& rows);
void add_contact(SchemaRows& rows);
void add_electrochemistry(SchemaRows& rows);
void add_coupling(SchemaRows& rows);
void add_water(SchemaRows& rows);
void add_strain(SchemaRows& rows);
void add_readout(SchemaRows& rows);
void add_run_control(SchemaRows& rows);

} // namespace ionskin
