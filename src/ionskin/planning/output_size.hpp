// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <cstddef>
#include <string>

namespace ionskin::planning {

/// Size of the files of a run, without its report [bytes]; rough: a history that compresses well
/// takes a third, one of a path with many rows more.
/// @param ion_unknowns,ion_steps of Study 2
double output_size(const Case& input, std::size_t ion_unknowns, std::size_t ion_steps);

/// The same as far as it is known before the case is solved: of a strain file without its history.
/// @param studies_ions whether Study 2 is run too
double expected_output(const Case& input, bool studies_ions);

/// Size of the tables alone, which a study keeps of each of its runs [bytes].
double expected_tables(const Case& input);

/// A sentence on files of gigabytes, for before they are written; empty for less.
/// @param bytes of all files
std::string announced_output(const Case& input, double bytes);

} // namespace ionskin::planning
