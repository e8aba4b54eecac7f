// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/server/json.hpp"

namespace ionskin::apps::studio {

/// Requires that the entries of manifest.json that a page uses have the types that it expects;
/// missing entries are allowed. Throws UserError with the first entry of another type.
void require_manifest(const Json& manifest);

/// Requires that the entries of summary.json or fit.json that a page uses have the types that it
/// expects; missing entries are allowed. Throws UserError with the first entry of another type.
void require_summary(const Json& summary);

} // namespace ionskin::apps::studio
