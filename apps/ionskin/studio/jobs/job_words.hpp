// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/data/workspace.hpp"

#include <string>
#include <vector>

namespace ionskin::apps::studio {

/// Arguments of a job. The Studio runs no others.
struct JobWords {
  std::string kind;    ///< "run", "sweep", "fit" or "report"
  std::string subject; ///< the case file, or the folder that is reported on
  std::string folder;  ///< of the results
};

/// Takes the arguments of a job apart and looks at every file and folder they name: it lies in the
/// workspace, and no link leads to it.
/// Throws HttpError 403, 404 or 422 with the argument that is refused.
JobWords require_inside(const Workspace& workspace, const std::vector<std::string>& words);

} // namespace ionskin::apps::studio
