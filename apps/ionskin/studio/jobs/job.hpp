// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/jobs/process.hpp"
#include "studio/server/json.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace ionskin::apps::studio {

/// State of a job of the Studio. `stopping`: asked to end, still running; `stopped`: ended early,
/// can be resumed; `found`: recorded in the workspace, runs only when the user says so.
enum class JobState { queued, running, stopping, stopped, finished, failed, found };

/// Command of ionskin that the Studio runs. Its folder among the Studio's records holds job.json;
/// while it runs also `output` and `messages`, its standard output and error; and end.json when it
/// has ended.
struct Job {
  std::string id;                 ///< id of the job, which is the name of its folder
  std::string kind;               ///< "run", "sweep", "fit" or "report"
  std::string folder;             ///< folder of the results, relative to the workspace
  std::vector<std::string> words; ///< arguments of the program ionskin
  std::string command, python;    ///< command line, and the same in Python, for the user to copy
  double memory = 0;              ///< estimated memory [bytes]; 0 when not known
  double seconds = 0;             ///< estimated time of the run [s]; 0 when not known
  JobState state = JobState::queued;
  /// Instants since 1970 [s]; 0 for those that have not come yet.
  double created = 0, started = 0, ended = 0;
  ProcessId keeper;  ///< process that runs the command and records its end, see `keep_job`
  int exit_code = 0; ///< exit code of the command once it has ended
  /// Reason why the job failed or was stopped; else the messages of the command.
  std::string message;

  bool runs() const { return state == JobState::running || state == JobState::stopping; }
  /// True if the job waits or runs.
  bool open() const { return state == JobState::queued || runs(); }
};

std::string to_string(JobState state);
/// JSON object of a job, as job.json holds it and pages get it.
Json to_json(const Job& job);
/// Reads job.json of a job in a folder of the Studio's own records.
/// Throws UserError when the record is damaged, or its job has another id than the folder's name.
Job read_job(const std::filesystem::path& folder);

} // namespace ionskin::apps::studio
