// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/system/free_memory.hpp"

#include <cstdlib> // defines __GLIBC__ if the C library is glibc

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace ionskin::base {

void return_free_memory() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

void keep_freed_blocks() {
#if defined(__GLIBC__)
  constexpr int largest_kept = 4 << 20, kept_at_the_top = 4 * largest_kept; // bytes
  mallopt(M_MMAP_THRESHOLD, largest_kept);
  mallopt(M_TRIM_THRESHOLD, kept_at_the_top);
#endif
}

} // namespace ionskin::base
