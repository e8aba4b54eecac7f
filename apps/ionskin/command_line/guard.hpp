// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace ionskin::apps {

/// Calls `body` and returns its exit code. An exception becomes a message on stderr and the exit
/// code of its kind, see `ExitCode`.
int guarded(const std::function<int()>& body);

/// Checks that the processor has the vector instructions for which this binary was compiled. Throws
/// UserError when it lacks some.
void require_vector_instructions();

} // namespace ionskin::apps
