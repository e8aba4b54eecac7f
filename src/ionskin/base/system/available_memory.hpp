// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin::base {

/// Memory that this process may still take.
struct AvailableMemory {
  double bytes = 0;
  std::string bound; ///< origin of the bound: "free on this machine"
};

/// The least of: what the machine has free, what the control group (of a container or a job)
/// leaves, what the limit of the address space (`ulimit -v`) leaves; $IONSKIN_MEMORY_LIMIT, such as
/// "12 GB", in place of all. Throws UserError when that cannot be read.
AvailableMemory available_memory();

} // namespace ionskin::base
