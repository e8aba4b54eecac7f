// SPDX-License-Identifier: Apache-2.0
#include "studio/jobs/job_records.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/files/read_json.hpp"
#include "studio/server/limits.hpp"

#include <algorithm>

namespace ionskin::apps::studio {

namespace fs = std::filesystem;

std::vector<Job> JobRecords::read() const {
  std::vector<Job> jobs;
  std::error_code error;
  for (const auto& folder : fs::directory_iterator(folder_, error)) {
    try {
      jobs.push_back(read_job(folder.path()));
    } catch (const UserError&) {
      continue; // a record that was never whole
    }
  }
  std::ranges::sort(jobs, {}, &Job::created);
  while (jobs.size() > limits::kept_jobs && !jobs.front().open()) {
    remove(jobs.front());
    jobs.erase(jobs.begin());
  }
  return jobs;
}

void JobRecords::create(Job& job) const {
  auto number = static_cast<std::uint64_t>(job.created * 1e3);
  do {
    job.id = std::to_string(number++);
  } while (!fs::create_directory(folder(job)));
  try {
    save(job);
  } catch (...) {
    remove(job);
    throw;
  }
}

void JobRecords::save(const Job& job) const {
  base::write_text_file(folder(job) / "job.json", dump(to_json(job)));
}

void JobRecords::remove(const Job& job) const {
  std::error_code error;
  fs::remove_all(folder(job), error);
}

std::optional<int> JobRecords::exit_code(const Job& job) const {
  const fs::path end = folder(job) / "end.json";
  if (!fs::exists(end)) {
    return std::nullopt;
  }
  const Json record = base::read_json(end, "record", limits::record).value_or(Json());
  return record.is_object() ? record.value("exit_code", -1) : -1;
}

void JobRecords::forget_run(const Job& job) const {
  std::error_code error;
  for (const char* name : {"end.json", "messages", "output"}) {
    fs::remove(folder(job) / name, error);
  }
}

} // namespace ionskin::apps::studio
