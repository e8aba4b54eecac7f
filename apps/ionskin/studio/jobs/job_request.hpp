// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/data/new_names.hpp"
#include "studio/jobs/job.hpp"

#include <optional>

namespace ionskin::apps::studio {

/// Job that a page of the Studio asks for, ready to be added to the queue: its case is checked, its
/// folder and case file are made, its command is filled in. The destructor removes the folder and
/// the file again unless `results->keep()` was called. The request is an object with "kind" and:
///   run     "case" (text), "name", optional "source" (a case file of the workspace, which is used
///           in place of a new one if its text is the same)
///   sweep   the entries of a run, and "over": [{"key", "values": [texts]}]
///   fit     the entries of a run, and "data" (a CSV file of the workspace), "column", "free":
///           [keys]
///   report  "path" of a run or a sweep
/// With "dry": true no file is made, for a page that only shows the command.
struct RequestedJob {
  /// Throws HttpError: 400 for a request that makes no sense, 422 for a case with mistakes.
  RequestedJob(const Workspace& workspace, const Json& request);

  Job job;
  /// Folder and case file that were made; nullopt for a report and for a dry request.
  std::optional<NewResults> results;
};

} // namespace ionskin::apps::studio
