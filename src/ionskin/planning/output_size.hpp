// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <cstddef>
#include <string>

namespace ionskin::planning {

/// Rough size of all files of a run, without its report [bytes]. A strain history that compresses
/// well takes a third of it, the history of a path with many rows takes more.
/// @param ion_unknowns number of unknowns of Study 2
/// @param ion_steps number of time steps of Study 2
double output_size(const Case& input, std::size_t ion_unknowns, std::size_t ion_steps);

/// Size of all files of a run, estimated from the case alone [bytes]. A strain file is not read, so
/// that readings over its duration do not count.
/// @param studies_ions true if Study 2 is run, too
double expected_output(const Case& input, bool studies_ions);

/// Size of the tables of signals and readings of one run [bytes], which a study keeps for each of
/// its runs.
double expected_tables(const Case& input);

/// Sentence that announces result files of more than 1 GB before they are written; empty for less.
/// @param bytes size of all files
std::string announced_output(const Case& input, double bytes);

} // namespace ionskin::planning
