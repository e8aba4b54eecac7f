// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <cstddef>

namespace ionskin::mechanics {

/// Steps that the contact is expected to take along a cycle of a motion.
std::size_t expected_steps(const Case& input);

} // namespace ionskin::mechanics
