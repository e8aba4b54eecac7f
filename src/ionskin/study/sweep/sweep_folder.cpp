// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/sweep_folder.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/own_build.hpp"
#include "ionskin/results/file_list.hpp"
#include "ionskin/results/manifest.hpp"
#include "ionskin/results/output_folder.hpp"
#include "ionskin/results/summary_json.hpp"
#include "ionskin/study/run/run_folder.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <climits>
#include <map>
#include <optional>
#include <vector>

namespace ionskin::study {
namespace {

namespace fs = std::filesystem;
namespace names = results::file_names;

std::string host_name() {
  std::array<char, HOST_NAME_MAX + 1> name{};
  if (gethostname(name.data(), name.size() - 1) != 0) {
    return "host";
  }
  std::string text = name.data();
  std::replace(text.begin(), text.end(), '/', '_');
  return text;
}

/// Reason why a point failed, from its manifest; empty if it did not fail, or if the manifest is of
/// another case or build.
std::optional<std::string> failure_in(const fs::path& folder, const SweepPoint& point) {
  const fs::path path = folder / names::manifest;
  if (!results::is_ionskin_manifest(path)) {
    return std::nullopt;
  }
  try {
    const results::Manifest manifest = results::read_manifest(path);
    const bool ours = manifest.input_hash == point.input_hash && base::own_build() &&
                      manifest.build == base::own_build()->hex();
    return ours && manifest.state == "failed" && !manifest.reason.empty()
               ? std::optional(manifest.reason)
               : std::nullopt;
  } catch (const UserError&) {
    return std::nullopt; // damaged
  }
}

void create_folder(const fs::path& folder) {
  results::refuse_link(folder);
  std::error_code error;
  fs::create_directory(folder, error);
  if (error) {
    throw UserError(
        fmt::format("the folder {} cannot be made: {}\n  = check the free space and the "
                    "permissions of the folders",
                    folder.string(), error.message()));
  }
}

/// Moves the files of a run one by one into a folder that also holds files of the user. The
/// manifest, which says that all files are there, comes last.
void move_files(const fs::path& from, results::OutputFolder& to) {
  for (const auto& entry : fs::directory_iterator(from)) {
    const std::string name = entry.path().filename().string();
    if (name != names::manifest && name != results::file_list_name) {
      fs::rename(entry.path(), to.own(name));
    }
  }
  fs::rename(from / names::manifest, to.own(names::manifest));
  fs::remove(from / results::file_list_name);
  fs::remove(from);
}

/// Renames a folder.
/// @return false if something is in the way that is not only ours
bool rename_whole(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (!error) {
    return true;
  }
  if (error != std::errc::directory_not_empty && error != std::errc::file_exists) {
    throw UserError(fmt::format(
        "the finished {} cannot be renamed to its final name: {}\n  = move away what is "
        "there, and finish the sweep with --resume",
        to.string(), error.message()));
  }
  return false;
}

std::vector<fs::path> entries(const fs::path& folder) {
  std::vector<fs::path> result;
  for (const auto& entry : fs::directory_iterator(folder)) {
    result.push_back(entry.path());
  }
  return result;
}

void publish_point(const fs::path& sweep, const fs::path& staged, const SweepPoint& point,
                   Studies studies) {
  const fs::path from = staged / point.name, to = sweep / names::points / point.name;
  if (rename_whole(from, to)) {
    return;
  }
  if (holds_finished_run(to, point.input_hash, studies)) {
    { const results::OutputFolder twin(from, results::ExistingFolder::overwrite); }
    fs::remove(from / results::file_list_name);
    fs::remove(from);
    return;
  }
  results::OutputFolder place(to, results::ExistingFolder::overwrite);
  fs::remove(to / results::file_list_name);
  if (!rename_whole(from, to)) {
    results::clear_file_list(to);
    move_files(from, place);
  }
}

} // namespace

PointState read_point_state(const fs::path& points, const SweepPoint& point, Studies studies) {
  const fs::path folder = points / point.name;
  if (holds_finished_run(folder, point.input_hash, studies)) {
    return {PointStatus::finished, "", results::read_metrics(folder / names::summary)};
  }
  if (const auto reason = failure_in(folder, point)) {
    return {PointStatus::failed, *reason, {}};
  }
  return {};
}

StagingPlace::StagingPlace(const fs::path& sweep, const std::string& work) : sweep_(sweep) {
  for (int attempt = 0;; ++attempt) {
    create_folder(sweep / names::staging);
    create_folder(sweep / names::points);
    path_ = sweep / names::staging / fmt::format("{}.{}.{}", work, host_name(), attempt);
    create_folder(path_);
    if (auto lock = results::lock_path(path_, results::LockKind::exclusive)) {
      lock_ = std::move(*lock);
      return;
    }
  }
}

StagingPlace::~StagingPlace() {
  std::error_code ignored; // only empty folders go
  fs::remove(path_, ignored);
  fs::remove(path_.parent_path(), ignored);
}

void StagingPlace::publish(const SweepPoint& point, Studies studies) const {
  publish_point(sweep_, path_, point, studies);
}

void settle_staging(const fs::path& sweep, const SweepPlan& plan, Studies studies, bool clear) {
  const fs::path staging = sweep / names::staging;
  results::refuse_link(staging);
  if (!fs::is_directory(staging)) {
    return;
  }
  std::map<std::string, const SweepPoint*> points;
  for (const SweepPoint& point : plan.points) {
    points[point.name] = &point;
  }
  create_folder(sweep / names::points);
  for (const fs::path& place : entries(staging)) {
    const auto lock = fs::is_directory(fs::symlink_status(place))
                          ? results::lock_path(place, results::LockKind::exclusive)
                          : std::nullopt;
    if (!lock) {
      continue;
    }
    for (const fs::path& entry : entries(place)) {
      const auto point = points.find(entry.filename().string());
      if (point != points.end() &&
          read_point_state(place, *point->second, studies).status != PointStatus::pending) {
        publish_point(sweep, place, *point->second, studies);
      }
    }
    if (clear) {
      results::remove_points(place);
    }
    std::error_code ignored; // only an empty folder goes
    fs::remove(place, ignored);
  }
  std::error_code ignored;
  fs::remove(staging, ignored);
}

} // namespace ionskin::study
