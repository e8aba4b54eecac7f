// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace ionskin::base {

/// Places of the parts of this copy of ionskin that are looked up when it runs. An installed copy
/// may be moved as a whole: its parts are found relative to the program or library that asks. A
/// program in its build tree uses the sources.
struct Installation {
  std::filesystem::path solver; ///< the program that computes
  std::filesystem::path data;   ///< folder with `cases` and `materials`
  std::filesystem::path python; ///< folder to import the Python package from
};

/// Installation of the running copy. What the environment replaces is left to the callers.
const Installation& installation();

/// The program, or the library that was loaded, that this code is part of.
std::filesystem::path own_file();

} // namespace ionskin::base
