// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/server/json.hpp"

#include <filesystem>
#include <string>

namespace ionskin::apps::studio {

/// Which fields results.h5 holds, with their grids and instants:
/// {"ions": {"x", "y", "z", "frames": [{"name", "time", "fields"}]},
///  "strain": {"x", "y", "z", "time", "frame", "slider_x", "slider_y"},
///  "contact": {"x", "y", "frames": [{"name", "time"}]}}; each null when there is none.
/// Lengths in m, from the skin's corner and the core's bottom, or from the slider's centre.
Json list_fields(const std::filesystem::path& results);

/// One field at one instant as a packed message of 32-bit floats, x fastest, then y, then z: the
/// heading {"shape", "unit", "least", "greatest"}.
/// @param group "ions", "strain" or "contact"
/// @param frame name of the instant; for strain its number
/// Throws HttpError 404 when it is not there.
std::string packed_field(const std::filesystem::path& results, const std::string& group,
                         const std::string& frame, const std::string& name);

} // namespace ionskin::apps::studio
