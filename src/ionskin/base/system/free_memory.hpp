// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::base {

/// Gives the free parts of the heap back to the system. Without it they stay with the program
/// wherever something later allocated lies above them: gigabytes after a large factorisation.
void return_free_memory();

} // namespace ionskin::base
