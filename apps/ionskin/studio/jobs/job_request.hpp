// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/data/new_names.hpp"
#include "studio/jobs/job.hpp"

#include <optional>

namespace ionskin::apps::studio {

/// The job that a page asks for: its case is checked, its names are taken, its commands filled in.
/// What was made for it goes again with this object, unless `results` are kept. The request has
/// "kind" and:
///   run     "case" text, "name", optional "source" (a case file that is used when its text is the
///           same)
///   sweep   the same, and "over": [{"key", "values": [texts]}]
///   fit     the same, and "data" (a CSV file of the workspace), "column", "free": [keys]
///   report  "path" of a run or a sweep
/// With "dry": true nothing is made: for the commands alone.
struct RequestedJob {
  /// Throws HttpError: 400 for a request that makes no sense, 422 for a case with mistakes.
  RequestedJob(const Workspace& workspace, const Json& request);

  Job job;
  std::optional<NewResults> results;
};

} // namespace ionskin::apps::studio
