// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/core_history.hpp"

namespace ionskin::history {

/// Coarsens a history: pairs of neighbouring cells along x and along y become one cell with their
/// mean, so that integrals over the core stay. Pairs are formed from both ends inwards, so that
/// symmetric fields stay symmetric; of an odd number, one or three cells make the middle one. Used
/// to estimate the error of the grid.
CoreHistory merge_cells(const CoreHistory& history);

} // namespace ionskin::history
