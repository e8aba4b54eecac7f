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

} // namespace ionskin::base
