// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

namespace ionskin::mechanics {

/// A short skin with a small slider on a very coarse mesh: the whole path in a fraction of a
/// second.
Case small_case();

} // namespace ionskin::mechanics
