// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

namespace ionskin::mechanics {

/// Checks that the slider touches at least one contact cell where it indents most. A cell touches
/// when the indentation exceeds the mean height of the underside over it, so that the mesh misses a
/// contact at a lowest point far from the centre under a small indentation. Cells are those of the
/// largest footprint, with which the search for the footprint begins.
/// Throws UserError, with the indentation that is needed, when no cell is touched.
void require_touch(const Case& input);

} // namespace ionskin::mechanics
