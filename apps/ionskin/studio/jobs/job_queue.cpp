// SPDX-License-Identifier: Apache-2.0
#include "studio/jobs/job_queue.hpp"

#include "ionskin/base/system/available_memory.hpp"
#include "studio/jobs/found_jobs.hpp"
#include "studio/jobs/job_words.hpp"
#include "studio/jobs/progress_log.hpp"
#include "studio/server/http_error.hpp"
#include "studio/server/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>

namespace ionskin::apps::studio {

namespace fs = std::filesystem;

namespace {

constexpr int interrupted = 130; // exit code of a command that was asked to stop

double now() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// Throws HttpError 409 when a job needs more memory than there is.
void require_memory(const Job& job) {
  const base::AvailableMemory available = base::available_memory();
  if (job.memory > available.bytes) {
    throw HttpError(409, fmt::format("this needs about {:.2g} GB of memory, and {:.2g} GB are {}: "
                                     "choose a coarser numerics.preset, a smaller "
                                     "numerics.mesh_refinement, or end other programs",
                                     job.memory * 1e-9, available.bytes * 1e-9, available.bound));
  }
}

/// Lets a run, sweep or fit that has begun continue from its finished parts.
void continue_from_parts(const Workspace& workspace, Job& job) {
  std::error_code error;
  const bool begun = fs::exists(workspace.root() / job.folder / "manifest.json", error);
  if (begun && job.kind != "report" && std::ranges::count(job.words, "--resume") == 0) {
    job.words.push_back("--resume");
    job.command += " --resume";
  }
}

} // namespace

JobQueue::JobQueue(const Workspace& workspace)
    : workspace_(workspace), records_(workspace.state() / "jobs") {
  // Found jobs have numbers that the Studio's own never have.
  for (FoundJob& found : find_jobs(workspace)) {
    found.job.id = std::to_string(entries_.size());
    entries_.push_back({.job = std::move(found.job), .found = std::move(found.name)});
  }
  for (Job& job : records_.read()) {
    entries_.push_back({std::move(job)});
  }
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
  const auto open = std::ranges::count_if(entries_, &Job::open, &Entry::job);
  if (static_cast<std::size_t>(open) >= limits::queued_jobs) {
    throw HttpError(429, fmt::format("{} jobs wait already; cancel some first", open));
  }
  require_memory(job);
  enqueue(std::move(job));
  return entries_.back().job.id;
}

void JobQueue::cancel(const std::string& id) {
  const std::lock_guard lock(mutex_);
  Entry& entry = *find(id);
  if (entry.job.state == JobState::queued) {
    entry.job.state = JobState::stopped;
    entry.job.message = "taken from the queue before it began";
  } else if (entry.job.state == JobState::running) {
    entry.job.state = JobState::stopping; // `press` sends the signal
  } else {
    throw HttpError(409, "this job has ended");
  }
  save(entry);
}

void JobQueue::resume(const std::string& id) {
  const std::lock_guard lock(mutex_);
  Entry& entry = *find(id);
  if (entry.job.open() || entry.job.state == JobState::finished) {
    throw HttpError(409, "only a job that was stopped or failed can be resumed");
  }
  Job job = entry.job;
  job.message.clear();
  if (job.state == JobState::found) {
    enqueue(std::move(job));
    forget(id);
    return;
  }
  continue_from_parts(workspace_, job);
  records_.forget_run(job);
  job.state = JobState::queued;
  entry = {std::move(job)};
  save(entry);
}

void JobQueue::remove(const std::string& id) {
  const std::lock_guard lock(mutex_);
  if (find(id)->job.open()) {
    throw HttpError(409, "this job waits or runs; cancel it first");
  }
  forget(id);
}

Job JobQueue::job(const std::string& id) {
  const std::lock_guard lock(mutex_);
  return find(id)->job;
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

std::vector<JobQueue::Entry>::iterator JobQueue::find(const std::string& id) {
  const auto entry =
      std::ranges::find_if(entries_, [&](const Entry& other) { return other.job.id == id; });
  if (entry == entries_.end()) {
    throw HttpError(404, "there is no such job");
  }
  return entry;
}

void JobQueue::enqueue(Job job) {
  job.created = now();
  job.state = JobState::queued;
  records_.create(job);
  entries_.push_back({std::move(job)});
  changed();
}

void JobQueue::forget(const std::string& id) {
  const auto entry = find(id);
  if (entry->found.empty()) {
    records_.remove(entry->job);
  } else {
    remove_found(workspace_, entry->found);
  }
  entries_.erase(entry);
  changed();
}

void JobQueue::save(const Entry& entry) {
  records_.save(entry.job);
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
        if (entry.job.runs()) {
          look_at(entry);
        }
      }
      start_next();
    } catch (const std::exception& error) {
      fmt::print(stderr, "warning: {}\n", error.what()); // such as a full disk; the server stays
    }
  }
}

void JobQueue::start_next() {
  if (std::ranges::any_of(entries_, &Job::runs, &Entry::job)) {
    return;
  }
  const auto next = std::ranges::find_if(
      entries_, [](const Entry& entry) { return entry.job.state == JobState::queued; });
  if (next != entries_.end()) {
    start(*next);
  }
}

void JobQueue::start(Entry& entry) {
  Job& job = entry.job;
  try {
    require_memory(job);
    require_inside(workspace_, job.words); // which may have become links while it waited
  } catch (const std::exception& error) {
    job.state = JobState::failed;
    job.message = error.what();
    save(entry);
    return;
  }
  const auto self = fs::canonical("/proc/self/exe");
  job.state = JobState::running;
  job.started = now();
  job.keeper =
      identify(start_detached({self.string(), "--keep", records_.folder(job).string()},
                              workspace_.folder(), records_.output(job), records_.messages(job)));
  save(entry);
}

void JobQueue::look_at(Entry& entry) {
  const bool alive = entry.job.keeper.alive();
  const ProgressLog log = read_progress(records_.messages(entry.job));
  Json progress = {{"activity", log.activity},
                   {"fraction", log.fraction},
                   {"left_s", log.left < 0 ? Json() : Json(log.left)},
                   {"elapsed_s", std::floor(now() - entry.job.started)}};
  if (progress != entry.progress) {
    entry.progress = std::move(progress);
    changed();
  }
  if (!alive || records_.exit_code(entry.job)) {
    end(entry);
  } else if (entry.job.state == JobState::stopping) {
    press(entry);
  }
}

/// Sends signals to a job that was asked to stop, by this server or an earlier one, and has not
/// ended: SIGINT at once, SIGTERM after 20 s, SIGKILL after 40 s.
void JobQueue::press(Entry& entry) {
  const double waited = now() - entry.asked_to_stop;
  if (entry.asked_to_stop == 0) {
    entry.asked_to_stop = now();
    kill(-entry.job.keeper.pid, SIGINT);
  } else if (waited > 40) {
    kill(-entry.job.keeper.pid, SIGKILL);
  } else if (waited > 20) {
    kill(-entry.job.keeper.pid, SIGTERM);
  }
}

void JobQueue::end(Entry& entry) {
  Job& job = entry.job;
  const std::optional<int> recorded = records_.exit_code(job);
  job.exit_code = recorded.value_or(interrupted);
  job.ended = now();
  job.message = recorded ? read_progress(records_.messages(job)).messages
                         : "the run was ended from outside; what it finished is kept";
  const bool stopped = job.exit_code == interrupted || job.state == JobState::stopping;
  job.state = job.exit_code == 0 ? JobState::finished
              : stopped          ? JobState::stopped
                                 : JobState::failed;
  save(entry);
}

} // namespace ionskin::apps::studio
