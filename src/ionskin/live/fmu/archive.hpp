// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/skin_data.hpp"

#include <filesystem>

namespace ionskin::live::fmu {

/// Writes an FMU for co-simulation by FMI 2.0: the description, the skin's file and the library
/// that steps it. Appears under its name when it is whole. The same skin gives the same bytes.
/// Throws base::UnwritableFile, and UserError when the library cannot be read.
/// @param path its stem becomes the name of the model
/// @param library the program's own, `ionskin_live_fmu.so`
void write_fmu(const std::filesystem::path& path, const SkinData& data,
               const std::filesystem::path& library);

} // namespace ionskin::live::fmu
