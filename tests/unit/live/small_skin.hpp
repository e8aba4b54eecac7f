// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/data/skin_data.hpp"

#include <cstddef>
#include <string>

namespace ionskin::live {

/// A made-up skin of four cells, whose compliance falls with their distance and whose shear at two
/// points is the drag on them.
SkinData small_skin();

/// Skin with so many square cells of 0.1 mm across under a sphere of 8 mm, on something like an
/// elastic half-space: each cell gives little by itself beside what its neighbours press it down
/// and drag it along. Within 20 N the contact stays within 11 cells across.
SkinData sphere_on_many_cells(std::size_t across);

/// Such a skin of 9 cells across, over a range of places, under a friction law with its parameters.
SkinData sphere_under(const std::string& law);

/// A skin whose slider's underside is turned by so much about x (0) or y (1) through its centre.
SkinData turned(SkinData data, std::size_t axis, double angle);

} // namespace ionskin::live
