// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <cstddef>
#include <string>

namespace ionskin::planning {

/// What the files of a run will take, without its report [bytes]; rough: a history that compresses
/// well takes a third, one of a path with many rows more.
/// @param ion_unknowns,ion_steps of Study 2
double output_size(const Case& input, std::size_t ion_unknowns, std::size_t ion_steps);

/// A sentence on files of gigabytes, for before they are written; empty for less.
/// @param bytes of all files
std::string announced_output(const Case& input, double bytes);

} // namespace ionskin::planning
