// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/skin_data.hpp"

namespace ionskin::live {

/// A made-up skin of four cells, whose compliance falls with their distance and whose shear at two
/// points is the drag on them.
SkinData small_skin();

} // namespace ionskin::live
