// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace ionskin::live {

/// Times that `new` took memory so far in this test program.
std::size_t allocations();

} // namespace ionskin::live
