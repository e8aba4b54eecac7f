// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace ionskin::mechanics {

/// Memory that a position takes while its factor is held, from the number of displacement unknowns
/// of the mesh [bytes].
double factorisation_memory(std::size_t unknowns);

/// Memory meant for factors that are held at the same time; one is held in any case [bytes].
constexpr double memory_for_factors = 2.4e9;

/// Memory that positions take together where `threads` would work on one each: fewer do where
/// their factors would not fit [bytes].
double factorisations_memory(std::size_t unknowns, int threads);

} // namespace ionskin::mechanics
