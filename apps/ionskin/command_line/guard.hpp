// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace ionskin::apps {

/// Runs the program's body and turns every exception into a message on stderr and its exit code.
int guarded(const std::function<int()>& body);

/// Throws UserError when the processor lacks the vector instructions this binary was compiled for.
void require_vector_instructions();

} // namespace ionskin::apps
