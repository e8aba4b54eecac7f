// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace ionskin::base {

/// Paths of the parts of this copy of ionskin that are needed at run time. Parts are found relative
/// to the running program or library, so an installed copy may be moved as a whole. A program in
/// its build tree uses the source folder.
struct Installation {
  std::filesystem::path solver; ///< program that runs the simulations
  std::filesystem::path data;   ///< folder with `cases` and `materials`
  std::filesystem::path python; ///< folder from which to import the Python package
};

/// Paths of the running copy, found once; environment variables do not change them.
const Installation& installation();

/// Path of the Python interpreter that runs ionskin's Python package: the environment variable
/// IONSKIN_PYTHON, which a wheel sets, or else the interpreter found when ionskin was built.
std::string python_interpreter();

/// Folder from which to import the Python package: the environment variable IONSKIN_PYTHON_PATH, or
/// else `Installation::python`.
std::filesystem::path python_package();

/// Path of the program or shared library that contains this code.
std::filesystem::path own_file();

} // namespace ionskin::base
