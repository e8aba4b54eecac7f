// SPDX-License-Identifier: Apache-2.0
#include "studio/jobs/found_jobs.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/files/read_json.hpp"
#include "ionskin/base/files/read_text_file.hpp"
#include "studio/data/case_check.hpp"
#include "studio/jobs/job_words.hpp"
#include "studio/server/limits.hpp"
#include "terminal/terminal.hpp"

#include <algorithm>
#include <filesystem>

namespace ionskin::apps::studio {

namespace fs = std::filesystem;

namespace {

base::FileDescriptor folder_of_records(const Workspace& workspace) {
  return open_below(workspace.folder(), fs::path(brought_records) / "jobs");
}

/// Takes the arguments of a record into a job, and makes the command to show from them; the texts
/// of the record are not shown, since they may say something else.
void take_words(const Json& record, Job& job) {
  record.at("words").get_to(job.words);
  std::vector<std::string> shown{"ionskin"};
  shown.insert(shown.end(), job.words.begin(), job.words.end());
  job.command = shell_text(shown);
  job.kind = job.words.empty() ? "" : job.words[0];
  const auto option = std::find(job.words.begin(), job.words.end(), "-o");
  if (job.words.end() - option > 1) {
    job.folder = option[1];
  } else if (job.words.size() > 1) {
    job.folder = job.words[1];
  }
}

Job read_found(const base::FileDescriptor& records, const std::string& name) {
  Job job;
  job.state = JobState::found;
  try {
    const fs::path file = fs::path(name) / "job.json";
    const auto record =
        base::read_json(open_below(records, file), file.string(), "record", limits::found_record);
    take_words(record.value_or(Json()), job);
    job.message = "This record of a job came with the folder. Nothing of it was run.";
  } catch (const Json::exception&) {
    job.words.clear();
    job.message = "This record came with the folder, and is none of a job.";
  } catch (const UserError& error) {
    job.message = error.what();
  }
  return job;
}

} // namespace

std::vector<FoundJob> find_jobs(const Workspace& workspace) {
  std::vector<FoundJob> found;
  const base::FileDescriptor records = folder_of_records(workspace);
  std::error_code error;
  for (fs::directory_iterator at(path_of(records), error), end;
       !error && at != end && found.size() < limits::found_jobs; at.increment(error)) {
    const std::string name = at->path().filename().string();
    found.push_back({name, read_found(records, name)});
  }
  return found;
}

void remove_found(const Workspace& workspace, const std::string& name) {
  const base::FileDescriptor records = folder_of_records(workspace);
  if (records < 0 || name.empty() || name == "." || name == ".." ||
      name.find('/') != std::string::npos) {
    return;
  }
  std::error_code error; // it is shown again, then
  fs::remove_all(path_of(records) / name, error);
}

void require_runnable(const Workspace& workspace, const Job& job) {
  const JobWords words = require_inside(workspace, job.words);
  if (words.kind == "report") {
    return;
  }
  const std::string text =
      base::read_text_file(workspace.open(words.subject).file, words.subject, "case", limits::body);
  require_valid(check_case(workspace, text));
}

} // namespace ionskin::apps::studio
