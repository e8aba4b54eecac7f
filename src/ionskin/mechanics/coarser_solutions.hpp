// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <string>

namespace ionskin::mechanics {

/// Names of the coarser solutions of Study 1. Their differences from the solution itself give its
/// error estimate.
namespace coarser_solutions {
inline constexpr const char* mesh = "mesh"; ///< element sizes twice as large
inline constexpr const char* path = "path"; ///< as `mesh`, and half the load steps and samples
/// Solution as `mesh`, but with twice the elements of `mesh` through the core.
inline constexpr const char* thickness = "thickness";
} // namespace coarser_solutions

/// The case that a coarser solution of `input` solves.
/// @param coarser a name in `coarser_solutions`
Case coarser_case(const Case& input, const std::string& coarser);

/// True if elements twice as large would leave the number of elements through the core as it is.
/// This happens at the preset `coarse`, which has a single element in each half of the core; the
/// error through the thickness then needs the solution `thickness`, which has more elements there.
bool needs_coarser_thickness(const Case& input);

} // namespace ionskin::mechanics
