// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <string>

namespace ionskin::mechanics {

/// Names of the coarser solutions of Study 1 whose differences tell its errors.
namespace coarser_solutions {
inline constexpr const char* mesh = "mesh";           ///< twice the mesh sizes
inline constexpr const char* path = "path";           ///< as mesh; half the load steps and samples
inline constexpr const char* thickness = "thickness"; ///< as mesh; twice the layers of elements
} // namespace coarser_solutions

/// The case that a coarser solution solves.
Case coarser_case(const Case& input, const std::string& coarser);

/// True if twice the mesh sizes would leave as many elements through the core: at the preset coarse
/// it has one in each half, and the coarser solution of twice the sizes cannot have fewer.
bool needs_coarser_thickness(const Case& input);

} // namespace ionskin::mechanics
