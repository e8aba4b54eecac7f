// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::base {

/// Returns free memory of the heap to the system (glibc's `malloc_trim`; does nothing with other C
/// libraries). Otherwise the process can keep gigabytes after a large factorisation, because later
/// allocations lie above the freed blocks.
void return_free_memory();

} // namespace ionskin::base
