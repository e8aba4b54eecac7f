// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ionskin::study {

/// Path of the Python interpreter that ionskin's Python package runs under.
std::string python_interpreter();

/// Runs `python -m MODULE ARGUMENTS...` with ionskin's package on the path and waits for it.
/// @return its exit code; -1 when the interpreter cannot be started or is killed
int run_python_module(const std::string& module, const std::vector<std::string>& arguments);

} // namespace ionskin::study
