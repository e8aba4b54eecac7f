// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/data/workspace.hpp"
#include "studio/jobs/job.hpp"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

namespace ionskin::apps::studio {

/// The jobs of a workspace, one running at a time. They are kept in files of the user's own,
/// outside the workspace: a new queue takes up what an earlier one left, whether it still runs,
/// waits or was ended with the machine. Jobs that the workspace brings are listed and wait for
/// `resume`.
class JobQueue {
public:
  explicit JobQueue(const Workspace& workspace);
  /// Running jobs go on.
  ~JobQueue();
  JobQueue(const JobQueue&) = delete;
  JobQueue& operator=(const JobQueue&) = delete;

  /// Puts a job at the end of the queue and returns its id. Throws HttpError: 409 when it needs
  /// more memory than is free, 429 when too many wait.
  std::string add(Job job);
  /// Throws HttpError 404 and, for jobs that ended, 409.
  void cancel(const std::string& id);
  /// Goes on with a job that was stopped, failed or found. What it would run is looked at first:
  /// `require_runnable`. Throws HttpError 404, 409.
  void resume(const std::string& id);
  /// Forgets a job that does not wait or run. Throws HttpError 404, 409.
  void remove(const std::string& id);
  /// Throws HttpError 404.
  Job job(const std::string& id) const;

  /// All jobs with their progress, the newest first.
  Json list() const;
  /// Grows whenever the list changes.
  std::uint64_t version() const { return version_; }
  /// Waits until the list differs from a version, the time is over or the queue ends. False at the
  /// end.
  bool wait(std::uint64_t version, std::chrono::milliseconds time) const;
  /// Ends all waiting.
  void close();

private:
  struct Entry {
    Job job;
    Json progress;
    double cancelled = 0;   ///< when it was asked to stop
    std::string found = {}; ///< name of its record in the workspace
  };
  Entry& find(const std::string& id);
  const Entry& find(const std::string& id) const;
  void adopt(Entry& entry);
  std::filesystem::path records(const Job& job) const;
  void load();
  void save(const Entry& entry);
  void changed();
  void watch();
  void look_at(Entry& entry);
  void press(Entry& entry);
  void end(Entry& entry);
  void start_next();
  void start(Entry& entry);
  void refuse(Entry& entry, const std::string& why);

  const Workspace& workspace_;
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::vector<Entry> entries_;
  std::atomic<std::uint64_t> version_ = 1;
  bool closed_ = false;
  std::thread watcher_;
};

/// Memory that programs can have without swapping [bytes].
double available_memory();

} // namespace ionskin::apps::studio
