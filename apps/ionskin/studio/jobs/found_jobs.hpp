// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/data/workspace.hpp"
#include "studio/jobs/job.hpp"

#include <string>
#include <vector>

namespace ionskin::apps::studio {

/// A record of a job that lies in the workspace: anybody may have put it there.
struct FoundJob {
  std::string name; ///< of its folder
  Job job;          ///< nothing but its arguments is taken from the record; none of a damaged one
};

/// Finds at most `limits::found_jobs` jobs.
std::vector<FoundJob> find_jobs(const Workspace& workspace);

/// Removes the folder of a record. What a link means stays.
void remove_found(const Workspace& workspace, const std::string& name);

/// Requires that a job may run at all, whoever recorded it: its arguments, and a case without
/// mistakes that names no file outside. Throws HttpError with what is refused.
void require_runnable(const Workspace& workspace, const Job& job);

} // namespace ionskin::apps::studio
