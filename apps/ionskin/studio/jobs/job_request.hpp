// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/data/workspace.hpp"
#include "studio/jobs/job.hpp"

namespace ionskin::apps::studio {

/// The job that a page asks for: checks the case, writes its file, and fills in the commands. The
/// request has "kind" and:
///   run     "case" text, "name", optional "source" (a case file that is used when its text is the
///           same)
///   sweep   the same, and "over": [{"key", "values": [texts]}]
///   fit     the same, and "data" (a CSV file of the workspace), "column", "free": [keys]
///   report  "path" of a run or a sweep
/// With "dry": true nothing is written: for the commands alone.
/// Throws HttpError: 400 for a request that makes no sense, 422 for a case with mistakes.
Job job_of(const Workspace& workspace, const Json& request);

} // namespace ionskin::apps::studio
