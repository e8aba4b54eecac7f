// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/data/workspace.hpp"
#include "studio/jobs/job.hpp"
#include "studio/jobs/job_records.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

namespace ionskin::apps::studio {

/// Queue of the jobs of a workspace, of which one runs at a time. A new queue takes over the
/// recorded jobs of an earlier server, whether they run, wait or were ended with the machine. Jobs
/// recorded in the workspace itself are listed, and wait for `resume`. All functions may be called
/// from several threads.
class JobQueue {
public:
  /// Reads the recorded jobs and starts the thread that starts and watches jobs.
  /// @param workspace must outlive the queue
  explicit JobQueue(const Workspace& workspace);
  /// Ends the thread; running jobs continue.
  ~JobQueue();
  JobQueue(const JobQueue&) = delete;
  JobQueue& operator=(const JobQueue&) = delete;

  /// Adds a job to the end of the queue and returns its id. Throws HttpError: 409 when it needs
  /// more memory than is free, 429 when too many jobs wait.
  std::string add(Job job);
  /// Stops a job that runs, or takes it from the queue when it waits. Throws HttpError 404 when
  /// there is no such job, 409 when it has ended.
  void cancel(const std::string& id);
  /// Queues a job again that was stopped, failed or found; a run continues from its finished parts.
  /// The caller checks the job first by `require_runnable`. Throws HttpError 404 when there is no
  /// such job, 409 when it is in another state.
  void resume(const std::string& id);
  /// Removes the record of a job that neither waits nor runs; its results stay. Throws HttpError
  /// 404 when there is no such job, 409 when it waits or runs.
  void remove(const std::string& id);
  /// Copy of a job. Throws HttpError 404 when there is no such job.
  Job job(const std::string& id);

  /// JSON array of all jobs with their progress, the newest first.
  Json list() const;
  /// Version of the list of jobs, a number that grows whenever the list changes.
  std::uint64_t version() const { return version_; }
  /// Waits until the list has another version than `version`, `time` is over, or the queue is
  /// closed. Returns false when it is closed.
  bool wait(std::uint64_t version, std::chrono::milliseconds time) const;
  /// Ends all calls of `wait`, and the thread of the queue.
  void close();

private:
  struct Entry {
    Job job;
    Json progress = nullptr; ///< progress of a running job; null before
    /// Instant at which it was asked to stop, since 1970 [s]; 0 if it was not.
    double asked_to_stop = 0;
    /// Name of its record in the workspace; empty for the Studio's own jobs.
    std::string found = {};
  };

  // The caller of these functions holds the mutex.
  std::vector<Entry>::iterator find(const std::string& id);
  /// Records a new job and lets it wait in the queue.
  void enqueue(Job job);
  /// Removes a job from the list, and its record.
  void forget(const std::string& id);
  void save(const Entry& entry);
  void changed();

  // The thread of the queue runs these functions.
  void watch();
  void start_next();
  void start(Entry& entry);
  void look_at(Entry& entry);
  void press(Entry& entry);
  void end(Entry& entry);

  const Workspace& workspace_;
  const JobRecords records_;
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::vector<Entry> entries_;
  std::atomic<std::uint64_t> version_ = 1;
  bool closed_ = false;
  std::thread watcher_;
};

} // namespace ionskin::apps::studio
