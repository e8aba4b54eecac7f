// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/data/workspace.hpp"
#include "studio/jobs/job.hpp"

#include <string>
#include <vector>

namespace ionskin::apps::studio {

/// Record of a job that lies in the workspace, where anybody may have put it; it is listed, and
/// runs only when the user says so.
struct FoundJob {
  std::string name; ///< name of the record's folder
  /// Job with the arguments of the record, and nothing else of it; without arguments where the
  /// record is damaged.
  Job job;
};

/// Finds the records of jobs in the workspace, at most `limits::found_jobs`.
std::vector<FoundJob> find_jobs(const Workspace& workspace);

/// Removes the folder of a record from the workspace. The target of a link is not removed.
void remove_found(const Workspace& workspace, const std::string& name);

/// Requires that a job may run, whoever recorded it: its arguments are those of a job, and its case
/// has no mistakes and names no file outside the workspace. Throws HttpError with the argument or
/// mistake that is refused.
void require_runnable(const Workspace& workspace, const Job& job);

} // namespace ionskin::apps::studio
