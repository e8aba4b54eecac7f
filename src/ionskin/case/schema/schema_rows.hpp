// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/coupling.hpp"
#include "ionskin/case/schema/schema.hpp"

#include <limits>
#include <numbers>
#include <vector>

namespace ionskin {

// Functions that append the rows of the schema, section by section, in the order of the reference
// page, and ranges that several rows share.

/// Rows of the schema in the order of the reference page.
using SchemaRows = std::vector<SchemaRow>;

inline constexpr double infinity = std::numeric_limits<double>::infinity();
// Ranges of a skin, a slider and their ions, with decades to spare on both sides. Beyond them
// numbers overflow or runs never end, and a wrong unit is more likely than such a value.
inline constexpr Range extent{1e-6, 10.0, true, true}; ///< lengths of skin and slider [m]
/// Largest tilt of a slider that the model approximates by a slope: 5 degrees [rad].
inline constexpr double steepest_tilt = 5 * std::numbers::pi / 180 * (1 + 1e-12);
/// Range of roll and pitch [rad].
inline constexpr Range tilt_range{-steepest_tilt, steepest_tilt, true, true};
inline constexpr const char* tilt_reason =
    "5 degrees, up to which a tilt is carried as a slope; give a steeper face as a height map";
inline constexpr Range turn_range{-1e3, 1e3, true, true}; ///< yaw [rad]
inline constexpr Range film{1e-9, 0.1, true, true};       ///< thickness of a layer [m]
inline constexpr Range place_on_skin{0.0, 10.0, true,
                                     true}; ///< x or y on the top face, or a gap there [m]
inline constexpr Range duration_range{1e-6, 1e7, true, true};      ///< [s]
inline constexpr Range concentration_range{1e-3, 1e6, true, true}; ///< [mol/m3]

/// True if the motion consists of strokes from slider.start, false if it goes through waypoints.
inline bool goes_in_strokes(const Case& input) {
  return input.motion.kind != MotionKind::waypoints;
}

/// True if the coupling law of a case has the coefficient k and a shear measure.
inline bool has_coupling_coefficient(const Case& input) {
  return !moves_water(input);
}

/// Appends the rows of the section [skin], but for its layers.
void add_skin(SchemaRows& rows);
/// Appends the rows of [[skin.layers]].
void add_layers(SchemaRows& rows);
/// Appends the rows of the elastic constants in [materials.NAME].
void add_materials(SchemaRows& rows);
/// Appends the rows of [materials.NAME] for ions and water: those rows of `add_electrochemistry`
/// and `add_water` whose values may come from the core's material.
void add_ions_of_materials(SchemaRows& rows);
/// Appends the rows of [slider].
void add_slider(SchemaRows& rows);
/// Appends the rows of [motion].
void add_motion(SchemaRows& rows);
/// Appends the rows of [contact].
void add_contact(SchemaRows& rows);
/// Appends the rows of [electrochemistry].
void add_electrochemistry(SchemaRows& rows);
/// Appends the rows of [coupling].
void add_coupling(SchemaRows& rows);
/// Appends the rows of [water].
void add_water(SchemaRows& rows);
/// Appends the rows of [strain].
void add_strain(SchemaRows& rows);
/// Appends the rows of [readout].
void add_readout(SchemaRows& rows);
/// Appends the rows of [numerics] and [output].
void add_run_control(SchemaRows& rows);

} // namespace ionskin
