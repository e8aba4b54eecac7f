// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/core_history.hpp"

namespace ionskin::history {

/// A history on cells twice as wide in x and y, each with the mean of those that it takes in:
/// integrals over the core stay. Cells are merged from both ends inwards, so that mirror images
/// stay.
CoreHistory merge_cells(const CoreHistory& history);

} // namespace ionskin::history
