// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin::base {

/// Memory that this process may still allocate, and what limits it.
struct AvailableMemory {
  double bytes = 0;
  std::string bound; ///< description of the limit, for messages: "free on this machine"
};

/// Finds the memory that this process may still allocate: the minimum of the free memory of the
/// machine and of what the limits of its control group (container or job) and of the address space
/// (`ulimit -v`) leave. The environment variable IONSKIN_MEMORY_LIMIT, such as "12 GB", replaces
/// them all. Throws UserError when the variable is not a size.
AvailableMemory available_memory();

} // namespace ionskin::base
