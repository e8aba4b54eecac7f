// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/data/skin_data.hpp"

#include <filesystem>

namespace ionskin::live::fmu {

/// Writes an FMU (zip archive) for co-simulation by FMI 2.0: model description, `.live` file of the
/// skin, and the library that steps it. The file appears under its name only when complete. The
/// same skin gives the same bytes. Throws base::UnwritableFile, and UserError when the library
/// cannot be read.
/// @param path of the FMU; its stem becomes the name of the model
/// @param library path of `ionskin_live_fmu.so`, which is part of ionskin
void write_fmu(const std::filesystem::path& path, const SkinData& data,
               const std::filesystem::path& library);

} // namespace ionskin::live::fmu
