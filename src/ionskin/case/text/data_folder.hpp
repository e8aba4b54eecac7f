// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace ionskin {

/// Path of the data folder, which contains the folders `cases` and `materials`: the environment
/// variable IONSKIN_DATA if it is set, else the folder of the installation.
std::filesystem::path data_folder();

} // namespace ionskin
