// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace ionskin::mechanics {

/// Memory that a position takes while its factor is held, from the number of displacement unknowns
/// of the mesh [bytes].
double factorisation_memory(std::size_t unknowns);

} // namespace ionskin::mechanics
