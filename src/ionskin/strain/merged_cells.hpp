// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/strain/strain_history.hpp"

namespace ionskin::strain {

/// The same history on cells twice as wide in x and y, each with the mean of those that it takes
/// in: integrals over the core stay. Cells are merged from both ends inwards, so that mirror images
/// stay.
StrainHistory merge_cells(const StrainHistory& history);

} // namespace ionskin::strain
