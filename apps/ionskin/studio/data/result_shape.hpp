// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/server/json.hpp"

namespace ionskin::apps::studio {

/// Requires that what a page takes from manifest.json has the types that it expects, where it is
/// there. Throws UserError with the first entry that has not.
void require_manifest(const Json& manifest);

/// Requires the types that a page expects of summary.json or fit.json. Throws UserError likewise.
void require_summary(const Json& summary);

} // namespace ionskin::apps::studio
