// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::finite_layers {

/// Number of states whose strains are calculated together, because the operator from forces to
/// strains does not fit the caches of a processor and is then read once for all of them. Fewer
/// states are filled up with zeros, so that the result of a state is bit for bit independent of the
/// number of states.
inline constexpr int states_at_once = 8;

} // namespace ionskin::finite_layers
