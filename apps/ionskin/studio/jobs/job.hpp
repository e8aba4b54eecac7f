// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/jobs/process.hpp"
#include "studio/server/json.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace ionskin::apps::studio {

/// State of a job. `stopping` was asked to end; `stopped` can be resumed; `found` came with the
/// workspace and runs only when the user says so.
enum class JobState { queued, running, stopping, stopped, finished, failed, found };

/// One command of ionskin that the Studio runs. Its folder among the Studio's records holds
/// job.json, and while it runs `output` and `messages`, and end.json when it ended.
struct Job {
  std::string id;                 ///< name of its folder
  std::string kind;               ///< "run", "sweep", "fit" or "report"
  std::string folder;             ///< of the results, relative to the workspace
  std::vector<std::string> words; ///< arguments of ionskin
  std::string command, python;    ///< the same to copy
  double memory = 0;              ///< memory that it needs [bytes]; 0 when not known
  double seconds = 0;             ///< time that it is expected to take [s]; 0 when not known
  JobState state = JobState::queued;
  double created = 0, started = 0, ended = 0; ///< [s] since 1970
  ProcessId keeper;                           ///< process that watches the command
  int exit_code = 0;
  std::string message; ///< reason why it failed

  bool open() const { return state <= JobState::stopping; }
};

std::string to_string(JobState state);
Json to_json(const Job& job);
/// Reads job.json in a folder of the Studio's own records.
/// Throws UserError for a record that is damaged, or of a job that is not named like its folder.
Job read_job(const std::filesystem::path& folder);

} // namespace ionskin::apps::studio
