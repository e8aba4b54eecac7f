// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::finite_layers {

/// States that are turned into strains at once, fewer filled up by others that are 0: each state is
/// the same bits in any company. The operator from forces to strains does not fit the caches of a
/// processor and is read once for all of them.
inline constexpr int states_at_once = 8;

} // namespace ionskin::finite_layers
