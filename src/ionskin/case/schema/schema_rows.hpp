// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/coupling.hpp"
#include "ionskin/case/schema/schema.hpp"

#include <limits>
#include <numbers>
#include <vector>

namespace ionskin {

// The rows of the schema, section by section, in the order of the reference page.

using SchemaRows = std::vector<SchemaRow>;

inline constexpr double infinity = std::numeric_limits<double>::infinity();
// Ranges of a skin, a slider and their ions, with decades to spare on both sides: beyond them
// numbers overflow or studies never end, and a slip of the unit is likelier than the value.
inline constexpr Range extent{1e-6, 10.0, true, true}; ///< of skin and slider [m]
/// Steepest tilt that a slope stands for: 5 degrees [rad].
inline constexpr double steepest_tilt = 5 * std::numbers::pi / 180 * (1 + 1e-12);
inline constexpr Range tilt_range{-steepest_tilt, steepest_tilt, true, true};
inline constexpr Range turn_range{-1e3, 1e3, true, true};          ///< [rad]
inline constexpr Range film{1e-9, 0.1, true, true};                ///< thickness of a layer [m]
inline constexpr Range place_on_skin{0.0, 10.0, true, true};       ///< [m]
inline constexpr Range duration_range{1e-6, 1e7, true, true};      ///< [s]
inline constexpr Range concentration_range{1e-3, 1e6, true, true}; ///< [mol/m3]

/// True if the motion starts at slider.start; waypoints bring their own places.
inline bool goes_in_strokes(const Case& input) {
  return input.motion.kind != MotionKind::waypoints;
}

/// True if the coupling law has the coefficient k and a measure of shear.
inline bool has_coupling_coefficient(const Case& input) {
  return !moves_water(input);
}

void add_skin(SchemaRows& rows);
void add_layers(SchemaRows& rows);
void add_materials(SchemaRows& rows);
/// Adds the properties of the ions that a material may give: the rows of `add_electrochemistry`
/// that may come from it.
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
