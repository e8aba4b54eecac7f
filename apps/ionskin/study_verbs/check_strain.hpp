// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verbs/check.hpp"

namespace ionskin::apps {

/// `check` of a case whose strain comes from a file: reads the file and says what `run` would say
/// of it. Throws UserError.
int check_with_strain_file(const CheckOptions& options);

} // namespace ionskin::apps
