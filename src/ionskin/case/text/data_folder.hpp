// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace ionskin {

/// The folder with `cases` and `materials`: that of the environment variable IONSKIN_DATA, or else
/// that of the installation.
std::filesystem::path data_folder();

} // namespace ionskin
