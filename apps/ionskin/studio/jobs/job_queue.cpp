// SPDX-License-Identifier: Apache-2.0
#include "studio/jobs/job_queue.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/files/read_json.hpp"
#include "studio/jobs/found_jobs.hpp"
#include "studio/jobs/job_words.hpp"
#include "studio/jobs/progress_log.hpp"
#include "studio/server/http_error.hpp"
#include "studio/server/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <ctime>
#include <fstream>

namespace ionskin::apps::studio {

namespace fs = std::filesystem;

namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

constexpr int interrupted = 130; // exit code of a command that was asked to stop

} // namespace

double available_memory() {
  std::ifstream file("/proc/meminfo");
  for (std::string name, unit; file >> name;) {
    double kibibytes = 0;
    file >> kibibytes;
    std::getline(file, unit);
    if (name == "MemAvailable:") {
      return kibibytes * 1024;
    }
  }
  return 0;
}

JobQueue::JobQueue(const Workspace& workspace) : workspace_(workspace) {
  load();
  watcher_ = std::thread([this] { watch(); });
}

JobQueue::~JobQueue() {
  close();
  watcher_.join();
}

void JobQueue::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  changed_.notify_all();
}

std::string JobQueue::add(Job job) {
  const std::lock_guard lock(mutex_);
  const auto open = std::count_if(entries_.begin(), entries_.end(),
                                  [](const Entry& entry) { return entry.job.open(); });
  if (static_cast<std::size_t>(open) >= limits::queued_jobs) {
    throw HttpError(429, fmt::format("{} jobs wait already; cancel some first", open));
  }
  const double available = available_memory();
  if (job.memory > available) {
    throw HttpError(409, fmt::format("this needs about {:.2g} GB of memory, and {:.2g} GB are "
                                     "free: choose a coarser numerics.preset, a smaller "
                                     "numerics.mesh_refinement, or end other programs",
                                     job.memory * 1e-9, available * 1e-9));
  }
  Entry entry{std::move(job), nullptr};
  adopt(entry);
  entries_.push_back(std::move(entry));
  return entries_.back().job.id;
}

/// Gives a job an id and a folder among the Studio's records, and lets it wait in the queue.
void JobQueue::adopt(Entry& entry) {
  entry.job.created = now();
  entry.job.state = JobState::queued;
  for (auto number = static_cast<std::uint64_t>(entry.job.created * 1e3);; ++number) {
    entry.job.id = fmt::format("{}", number);
    if (fs::create_directory(records(entry.job))) {
      break;
    }
  }
  try {
    save(entry);
  } catch (...) {
    std::error_code error;
    fs::remove_all(records(entry.job), error);
    throw;
  }
}

const JobQueue::Entry& JobQueue::find(const std::string& id) const {
  const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& other) { return other.job.id == id; });
  if (entry == entries_.end()) {
    throw HttpError(404, "there is no such job");
  }
  return *entry;
}

JobQueue::Entry& JobQueue::find(const std::string& id) {
  return const_cast<Entry&>(std::as_const(*this).find(id));
}

void JobQueue::cancel(const std::string& id) {
  const std::lock_guard lock(mutex_);
  Entry& entry = find(id);
  if (entry.job.state == JobState::queued) {
    entry.job.state = JobState::stopped;
    entry.job.message = "taken from the queue before it began";
  } else if (entry.job.state == JobState::running) {
    entry.job.state = JobState::stopping;
    entry.cancelled = now();
    kill(-entry.job.keeper.pid, SIGINT);
  } else {
    throw HttpError(409, "this job has ended");
  }
  save(entry);
}

void JobQueue::resume(const std::string& id) {
  const std::lock_guard lock(mutex_);
  Entry& entry = find(id);
  if (entry.job.state < JobState::stopped || entry.job.state == JobState::finished) {
    throw HttpError(409, "only a job that was stopped or failed can be resumed");
  }
  if (entry.job.state == JobState::found) {
    Entry own{entry.job, nullptr};
    own.job.message.clear();
    adopt(own);
    remove_found(workspace_, entry.found);
    entry = std::move(own);
    std::rotate(entries_.begin() + (&entry - entries_.data()),
                entries_.begin() + (&entry - entries_.data()) + 1, entries_.end());
    return;
  }
  std::error_code error;
  Job& job = entry.job;
  const bool begun = fs::exists(workspace_.root() / job.folder / "manifest.json", error);
  if (begun && job.kind != "report" &&
      std::find(job.words.begin(), job.words.end(), "--resume") == job.words.end()) {
    job.words.push_back("--resume");
    job.command += " --resume";
  }
  fs::remove(records(job) / "end.json", error);
  fs::remove(records(job) / "messages", error);
  fs::remove(records(job) / "output", error);
  job.state = JobState::queued;
  job.message.clear();
  entry.progress = nullptr;
  save(entry);
}

void JobQueue::remove(const std::string& id) {
  const std::lock_guard lock(mutex_);
  Entry& entry = find(id);
  if (entry.job.open()) {
    throw HttpError(409, "this job waits or runs; cancel it first");
  }
  if (entry.job.state == JobState::found) {
    remove_found(workspace_, entry.found);
  } else {
    std::error_code error;
    fs::remove_all(records(entry.job), error);
  }
  entries_.erase(entries_.begin() + (&entry - entries_.data()));
  changed();
}

Job JobQueue::job(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  return find(id).job;
}

Json JobQueue::list() const {
  const std::lock_guard lock(mutex_);
  Json all = Json::array();
  for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry) {
    Json one = to_json(entry->job);
    one.erase("pid_started");
    one["progress"] = entry->progress;
    all.push_back(std::move(one));
  }
  return all;
}

bool JobQueue::wait(std::uint64_t version, std::chrono::milliseconds time) const {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, time, [&] { return closed_ || version_ != version; });
  return !closed_;
}

fs::path JobQueue::records(const Job& job) const {
  return workspace_.state() / "jobs" / job.id;
}

void JobQueue::load() {
  std::error_code error;
  for (const auto& folder : fs::directory_iterator(workspace_.state() / "jobs", error)) {
    try {
      entries_.push_back({read_job(folder.path()), nullptr});
    } catch (const UserError&) {
      continue; // a record that was never whole
    }
  }
  std::sort(entries_.begin(), entries_.end(),
            [](const Entry& a, const Entry& b) { return a.job.created < b.job.created; });
  while (entries_.size() > limits::kept_jobs && !entries_.front().job.open()) {
    fs::remove_all(records(entries_.front().job), error);
    entries_.erase(entries_.begin());
  }
  // Before the Studio's own in the list, with numbers that those never have.
  std::size_t number = 0;
  for (FoundJob& found : find_jobs(workspace_)) {
    found.job.id = fmt::format("{}", number);
    entries_.insert(entries_.begin(), {std::move(found.job), nullptr, 0, std::move(found.name)});
    ++number;
  }
}

void JobQueue::save(const Entry& entry) {
  base::write_text_file(records(entry.job) / "job.json", dump(to_json(entry.job)));
  changed();
}

void JobQueue::changed() {
  ++version_;
  changed_.notify_all();
}

void JobQueue::watch() {
  for (;;) {
    std::unique_lock lock(mutex_);
    if (changed_.wait_for(lock, limits::poll, [this] { return closed_; })) {
      return;
    }
    try {
      for (Entry& entry : entries_) {
        if (entry.job.state == JobState::running || entry.job.state == JobState::stopping) {
          look_at(entry);
        }
      }
      start_next();
    } catch (const std::exception& error) {
      fmt::print(stderr, "warning: {}\n", error.what()); // such as a full disk; the server stays
    }
  }
}

void JobQueue::look_at(Entry& entry) {
  const bool alive = entry.job.keeper.alive();
  const ProgressLog log = read_progress(records(entry.job) / "messages");
  Json progress = {{"activity", log.activity},
                   {"fraction", log.fraction},
                   {"left_s", log.left < 0 ? Json() : Json(log.left)},
                   {"elapsed_s", std::floor(now() - entry.job.started)}};
  if (progress != entry.progress) {
    entry.progress = std::move(progress);
    changed();
  }
  if (!alive || fs::exists(records(entry.job) / "end.json")) {
    end(entry);
  } else if (entry.job.state == JobState::stopping) {
    press(entry);
  }
}

/// Sends a stronger signal to a job that was asked to stop and has not ended: SIGTERM after 20 s,
/// SIGKILL after 40 s.
void JobQueue::press(Entry& entry) {
  const double waited = now() - entry.cancelled;
  if (entry.cancelled == 0) { // cancelled by an earlier server
    entry.cancelled = now();
    kill(-entry.job.keeper.pid, SIGINT);
  } else if (waited > 40) {
    kill(-entry.job.keeper.pid, SIGKILL);
  } else if (waited > 20) {
    kill(-entry.job.keeper.pid, SIGTERM);
  }
}

void JobQueue::end(Entry& entry) {
  Job& job = entry.job;
  const fs::path end_record = records(job) / "end.json";
  const bool recorded = fs::exists(end_record);
  job.exit_code = interrupted;
  if (recorded) {
    const Json record = base::read_json(end_record, "record", limits::record).value_or(Json());
    job.exit_code = record.is_object() ? record.value("exit_code", -1) : -1;
  }
  job.ended = now();
  job.message = read_progress(records(job) / "messages").messages;
  if (job.exit_code == 0) {
    job.state = JobState::finished;
  } else if (job.exit_code == interrupted || job.state == JobState::stopping) {
    job.state = JobState::stopped;
    if (!recorded) {
      job.message = "the run was ended from outside; what it finished is kept";
    }
  } else {
    job.state = JobState::failed;
  }
  save(entry);
}

void JobQueue::start_next() {
  const auto busy = [](const Entry& entry) {
    return entry.job.state == JobState::running || entry.job.state == JobState::stopping;
  };
  if (std::any_of(entries_.begin(), entries_.end(), busy)) {
    return;
  }
  const auto next = std::find_if(entries_.begin(), entries_.end(), [](const Entry& entry) {
    return entry.job.state == JobState::queued;
  });
  if (next != entries_.end()) {
    start(*next);
  }
}

void JobQueue::refuse(Entry& entry, const std::string& why) {
  entry.job.state = JobState::failed;
  entry.job.message = why;
  save(entry);
}

void JobQueue::start(Entry& entry) {
  Job& job = entry.job;
  const double available = available_memory();
  if (job.memory > available) {
    refuse(entry, fmt::format("this needs about {:.2g} GB of memory, and {:.2g} GB are free",
                              job.memory * 1e-9, available * 1e-9));
    return;
  }
  try {
    require_inside(workspace_, job.words); // which may have become links while it waited
  } catch (const HttpError& error) {
    refuse(entry, error.what());
    return;
  }
  const fs::path folder = records(job);
  const auto self = fs::canonical("/proc/self/exe");
  job.state = JobState::running;
  job.started = now();
  const pid_t keeper = start_detached({self.string(), "--keep", folder.string()},
                                      workspace_.folder(), folder / "output", folder / "messages");
  job.keeper = identify(keeper);
  save(entry);
}

} // namespace ionskin::apps::studio
