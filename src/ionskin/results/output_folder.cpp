// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/output_folder.hpp"

#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/results/file_list.hpp"
#include "ionskin/results/manifest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <system_error>

namespace ionskin::results {
namespace {

namespace fs = std::filesystem;

constexpr std::array subfolders{file_names::fields, file_names::figures, file_names::points,
                                file_names::staging, file_names::evaluations};
constexpr std::array top_files{
    file_names::manifest,       file_names::case_text,       file_names::summary,
    file_names::signals,        file_names::sampled,         file_names::taxels,
    file_names::sampled_taxels, file_names::sampled_circuit, file_names::signals_error,
    file_names::sampled_error,  file_names::taxels_error,    file_names::circuit_error,
    file_names::circuit,        file_names::impedance,       file_names::fit,
    file_names::fit_table,      file_names::fitted_case,     file_names::results,
    file_names::checkpoint,     file_names::report,          file_names::sweep_table,
    file_names::sweep_signals,  file_names::sweep_plan,      file_names::water,
    file_names::water_error};

/// File status of a path, without following symbolic links.
fs::file_status status_of(const fs::path& path) {
  std::error_code ignored;
  return fs::symlink_status(path, ignored);
}

bool is_folder(const fs::path& path) {
  return fs::is_directory(status_of(path));
}

bool is_ours(const fs::path& folder) {
  return is_ionskin_manifest(folder / file_names::manifest) || read_file_list(folder).has_value();
}

/// True if a folder is empty, or holds only temporary list files that a killed program had not yet
/// renamed; the list file is the first file that is written to a folder.
bool is_fresh(const fs::path& folder) {
  const std::string pending = std::string(file_list_name) + ".";
  return std::all_of(fs::directory_iterator(folder), fs::directory_iterator(),
                     [&](const fs::directory_entry& entry) {
                       return fs::is_regular_file(status_of(entry.path())) &&
                              entry.path().filename().string().starts_with(pending);
                     });
}

void require_own(const fs::path& folder, ExistingFolder existing) {
  if (is_ours(folder)) {
    return;
  }
  const char* option = existing == ExistingFolder::overwrite ? "--overwrite" : "--resume";
  throw UserError(
      fmt::format("the folder {} holds files but no manifest.json of ionskin, so {} would touch "
                  "files that are not ours\n  = choose another folder with -o, or empty this one",
                  folder.string(), option));
}

[[noreturn]] void throw_foreign(const fs::path& path) {
  throw UserError(fmt::format("{} is in the way of a result and was not written by ionskin, which "
                              "replaces its own files only\n  = move it away, or choose another "
                              "folder with -o",
                              path.string()));
}

/// Names of the results of versions of ionskin that wrote no list file; their figures are not
/// included, so they stay.
std::set<std::string> unlisted_results(const fs::path& folder) {
  std::set<std::string> names(top_files.begin(), top_files.end());
  std::error_code error;
  const fs::path fields = folder / file_names::fields;
  for (fs::directory_iterator at(fields, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (is_folder(fields) && name.starts_with("fields") &&
        (name.ends_with(".vtu") || name.ends_with(".pvd"))) {
      names.insert(std::string(file_names::fields) + "/" + name);
    }
  }
  return names;
}

void create(const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) {
    throw UserError(fmt::format("the output folder {} exists and is a file\n  = choose another "
                                "folder with -o",
                                folder.string()));
  }
  fs::create_directories(folder, error);
  if (error) {
    throw UserError(fmt::format("the output folder {} cannot be created: {}\n  = choose a folder "
                                "that you may write with -o",
                                folder.string(), error.message()));
  }
}

} // namespace

void refuse_link(const fs::path& path) {
  if (fs::is_symlink(status_of(path))) {
    throw UserError(fmt::format("{} is a link, and ionskin writes nothing through a link out of "
                                "its folder\n  = remove the link, or choose another folder with -o",
                                path.string()));
  }
}

PathLock lock_output_folder(const fs::path& folder, LockKind kind) {
  auto lock = lock_path(folder, kind);
  if (!lock) {
    throw UserError(fmt::format("another ionskin is writing to the folder {}\n  = wait until it "
                                "has ended, or choose another folder with -o",
                                folder.string()));
  }
  return std::move(*lock);
}

OutputFolder::OutputFolder(fs::path folder, ExistingFolder existing, LockKind lock)
    : folder_(std::move(folder)) {
  create(folder_);
  lock_ = lock_output_folder(folder_, lock);
  try {
    make_ready(existing, lock);
  } catch (const fs::filesystem_error& error) {
    throw UserError(fmt::format("the output folder {} cannot be made ready: {}\n  = choose another "
                                "folder with -o",
                                folder_.string(), error.code().message()));
  }
}

void OutputFolder::make_ready(ExistingFolder existing, LockKind lock) {
  if (is_fresh(folder_)) {
    clear_file_list(folder_);
    return;
  }
  if (existing == ExistingFolder::refuse) {
    throw UserError(fmt::format("the output folder {} already holds files\n  = replace earlier "
                                "results with --overwrite, finish an interrupted run with "
                                "--resume, or choose another folder with -o",
                                folder_.string()));
  }
  require_own(folder_, existing);
  for (const char* name : subfolders) {
    refuse_link(folder_ / name);
  }
  const auto listed = read_file_list(folder_);
  owned_ = listed.value_or(unlisted_results(folder_));
  for (const char* name : top_files) {
    if (owned_.count(name) == 0 && fs::exists(status_of(folder_ / name))) {
      throw_foreign(folder_ / name);
    }
  }
  // Writes to the folder before anything is removed, to find out whether it is writable.
  if (!listed) {
    clear_file_list(folder_);
    for (const std::string& name : owned_) {
      if (fs::exists(status_of(folder_ / name))) {
        add_to_file_list(folder_, name);
      }
    }
  } else {
    base::PendingFile probe(folder_ / file_list_name);
  }
  if (lock == LockKind::exclusive) { // with a shared lock, another process may be writing them
    base::remove_pending_files(folder_);
    for (const char* name : subfolders) {
      base::remove_pending_files(folder_ / name);
    }
  }
  if (existing == ExistingFolder::overwrite) {
    remove_results();
    remove_points(folder_ / file_names::points);
    remove_staging();
  }
}

fs::path OutputFolder::own(const std::string& name) {
  const fs::path path = folder_ / name;
  if (!is_inner_name(name)) {
    throw InternalError(name + " is not a name of a result");
  }
  const fs::path parent = path.parent_path();
  if (fs::path(name).has_parent_path()) {
    refuse_link(parent);
    std::error_code error;
    fs::create_directory(parent, error);
    if (error) {
      throw base::UnwritableFile(parent, error.message());
    }
  }
  if (owned_.count(name) == 0) {
    if (fs::exists(status_of(path))) {
      throw_foreign(path);
    }
    add_to_file_list(folder_, name);
    owned_.insert(name);
  }
  return path;
}

void OutputFolder::remove(const std::string& name) {
  const fs::path path = folder_ / name;
  const bool inside = !fs::path(name).has_parent_path() || is_folder(path.parent_path());
  if (owned_.count(name) > 0 && inside && !is_folder(path)) {
    std::error_code ignored;
    fs::remove(path, ignored);
  }
}

void OutputFolder::remove_results() {
  for (const std::string& name : owned_) {
    remove(name);
  }
  owned_.clear();
  std::error_code ignored;
  for (const char* name : {file_names::fields, file_names::figures, file_names::evaluations}) {
    fs::remove(folder_ / name, ignored); // removes only an empty folder
  }
  clear_file_list(folder_);
}

void OutputFolder::discard() {
  remove_results();
  std::error_code ignored;
  fs::remove(folder_ / file_list_name, ignored);
}

void OutputFolder::remove_staging() {
  std::error_code ignored;
  const fs::path staging = folder_ / file_names::staging;
  for (const auto& entry : fs::directory_iterator(staging, ignored)) {
    if (is_folder(entry.path())) {
      remove_points(entry.path());
    }
  }
  fs::remove(staging, ignored);
}

void remove_points(const fs::path& points) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(points, ignored)) {
    if (is_folder(entry.path()) && is_ours(entry.path())) {
      { const OutputFolder point(entry.path(), ExistingFolder::overwrite); }
      const auto left = std::distance(fs::directory_iterator(entry.path()), {});
      if (left == 1) { // only the list file
        fs::remove(entry.path() / file_list_name, ignored);
        fs::remove(entry.path(), ignored);
      }
    }
  }
  fs::remove(points, ignored);
}

} // namespace ionskin::results
