// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/data/workspace.hpp"

#include <string>
#include <vector>

namespace ionskin::apps::studio {

/// Arguments of a job that `require_inside` allowed; the Studio runs no other commands.
struct JobWords {
  std::string kind;    ///< "run", "sweep", "fit" or "report"
  std::string subject; ///< name of the case file, or of the folder of which a report is made
  std::string folder;  ///< name of the folder of the results
};

/// Parses the arguments of a job, and requires that every file and folder they name lies in the
/// workspace and is reached without a link.
/// @param words arguments of the program ionskin
/// Throws HttpError 403, 404 or 422 with the argument that is refused.
JobWords require_inside(const Workspace& workspace, const std::vector<std::string>& words);

} // namespace ionskin::apps::studio
