// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace ionskin::base {

/// Places of the parts of this copy of ionskin that are looked up when it runs. An installed copy
/// may be moved as a whole: its parts are found relative to the program or library that asks. A
/// program in its build tree uses the sources.
struct Installation {
  std::filesystem::path solver; ///< the program that computes
  std::filesystem::path data;   ///< folder with `cases` and `materials`
  std::filesystem::path python; ///< folder to import the Python package from
};

/// Installation of the running copy, whatever the environment replaces.
const Installation& installation();

/// Path of the Python interpreter that ionskin's Python package runs under: IONSKIN_PYTHON of the
/// environment, as in a wheel, or the one that was there when ionskin was built.
std::string python_interpreter();

/// Folder to import the Python package from: IONSKIN_PYTHON_PATH of the environment, or that of the
/// installation.
std::filesystem::path python_package();

/// The program, or the library that was loaded, that this code is part of.
std::filesystem::path own_file();

} // namespace ionskin::base
