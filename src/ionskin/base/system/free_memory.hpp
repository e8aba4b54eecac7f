// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::base {

/// Returns free memory of the heap to the system (glibc's `malloc_trim`; does nothing with other C
/// libraries). Otherwise the process can keep gigabytes after a large factorisation, because later
/// allocations lie above the freed blocks.
void return_free_memory();

/// Keeps freed blocks of up to some megabytes for later allocations of this process (glibc's
/// `mallopt`; does nothing with other C libraries). Without it, glibc maps each matrix of more than
/// 128 KiB anew, and the system clears its pages again. To be called before threads start.
void keep_freed_blocks();

} // namespace ionskin::base
