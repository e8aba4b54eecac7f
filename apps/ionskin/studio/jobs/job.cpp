// SPDX-License-Identifier: Apache-2.0
#include "studio/jobs/job.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/files/read_json.hpp"
#include "studio/server/limits.hpp"

#include <array>

namespace ionskin::apps::studio {
namespace {

constexpr std::array<const char*, 7> names{"queued",   "running", "stopping", "stopped",
                                           "finished", "failed",  "found"};

JobState state_of(const std::string& name) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (name == names[i]) {
      return static_cast<JobState>(i);
    }
  }
  return JobState::failed;
}

Job job_of_record(const Json& record) {
  Job job;
  record.at("id").get_to(job.id);
  record.at("kind").get_to(job.kind);
  record.at("folder").get_to(job.folder);
  record.at("words").get_to(job.words);
  record.at("command").get_to(job.command);
  record.at("python").get_to(job.python);
  record.at("memory_bytes").get_to(job.memory);
  record.at("expected_s").get_to(job.seconds);
  job.state = state_of(record.at("state").get<std::string>());
  record.at("created").get_to(job.created);
  record.at("started").get_to(job.started);
  record.at("ended").get_to(job.ended);
  record.at("pid").get_to(job.keeper.pid);
  record.at("pid_started").get_to(job.keeper.started);
  record.at("exit_code").get_to(job.exit_code);
  record.at("message").get_to(job.message);
  return job;
}

} // namespace

std::string to_string(JobState state) {
  return names[static_cast<std::size_t>(state)];
}

Json to_json(const Job& job) {
  return {{"id", job.id},
          {"kind", job.kind},
          {"folder", job.folder},
          {"words", job.words},
          {"command", job.command},
          {"python", job.python},
          {"memory_bytes", job.memory},
          {"expected_s", job.seconds},
          {"state", to_string(job.state)},
          {"created", job.created},
          {"started", job.started},
          {"ended", job.ended},
          {"pid", job.keeper.pid},
          {"pid_started", job.keeper.started},
          {"exit_code", job.exit_code},
          {"message", job.message}};
}

Job read_job(const std::filesystem::path& folder) {
  const auto record = base::read_json(folder / "job.json", "record", limits::record);
  try {
    Job job = job_of_record(record.value_or(Json()));
    if (job.id == folder.filename()) {
      return job;
    }
  } catch (const Json::exception&) {
    // said below
  }
  throw UserError("the record of a job in " + folder.string() + " is damaged\n  = remove it");
}

} // namespace ionskin::apps::studio
