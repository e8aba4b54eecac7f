// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/jobs/job.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace ionskin::apps::studio {

/// Records of jobs in the user's own files, which outlive a server. Each job has a folder, see
/// `Job`.
class JobRecords {
public:
  /// @param folder folder of all records; must exist
  explicit JobRecords(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Reads all jobs, the oldest first, and removes the oldest of more than `limits::kept_jobs`.
  /// Damaged records are left out.
  std::vector<Job> read() const;
  /// Gives a new job its id, and records it.
  void create(Job& job) const;
  void save(const Job& job) const;
  void remove(const Job& job) const;

  /// Standard error of the job's command.
  std::filesystem::path messages(const Job& job) const { return folder(job) / "messages"; }
  /// Standard output of the job's command.
  std::filesystem::path output(const Job& job) const { return folder(job) / "output"; }
  std::filesystem::path folder(const Job& job) const { return folder_ / job.id; }
  /// Reads the exit code that the keeper has recorded, see `keep_job`; -1 in a damaged record,
  /// nothing when there is none yet.
  std::optional<int> exit_code(const Job& job) const;
  /// Removes what the last run of the command has left.
  void forget_run(const Job& job) const;

private:
  std::filesystem::path folder_;
};

} // namespace ionskin::apps::studio
