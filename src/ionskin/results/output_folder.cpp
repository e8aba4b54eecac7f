// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/output_folder.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/results/atomic_file.hpp"
#include "ionskin/results/manifest.hpp"

#include <fmt/format.h>

#include <set>
#include <string>
#include <system_error>

namespace ionskin::results {
namespace {

namespace fs = std::filesystem;

void remove_by_extension(const fs::path& folder, const std::set<std::string>& extensions) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.is_regular_file() && extensions.count(entry.path().extension().string()) > 0) {
      fs::remove(entry.path());
    }
  }
  // Only an empty folder goes.
  fs::remove(folder, ignored);
}

void remove_results(const fs::path& folder) {
  for (const char* name :
       {file_names::case_text, file_names::summary, file_names::signals, file_names::sampled,
        file_names::taxels, file_names::circuit, file_names::sampled_taxels,
        file_names::sampled_circuit, file_names::impedance, file_names::results,
        file_names::checkpoint, file_names::report, file_names::manifest, file_names::sweep_table,
        file_names::sweep_signals, file_names::fit, file_names::fit_table,
        file_names::fitted_case}) {
    fs::remove(folder / name);
    fs::remove(folder / (std::string(name) + ".tmp"));
  }
  remove_by_extension(folder / file_names::fields, {".vtu", ".pvd"});
  remove_by_extension(folder / file_names::evaluations, {".h5", ".tmp"});
  remove_by_extension(folder / file_names::figures, {".png", ".svg", ".pdf"});
}

void require_own(const fs::path& folder, ExistingFolder existing) {
  if (is_ionskin_manifest(folder / file_names::manifest)) {
    return;
  }
  const char* option = existing == ExistingFolder::overwrite ? "--overwrite" : "--resume";
  throw UserError(
      fmt::format("the folder {} holds files but no manifest.json of ionskin, so {} would touch "
                  "files that are not ours\n  = choose another folder with -o, or empty this one",
                  folder.string(), option));
}

void require_writable(const fs::path& folder) {
  const fs::path probe = folder / ".ionskin-write-test";
  write_text_file(probe, "");
  fs::remove(probe);
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

void make_room(const fs::path& folder, ExistingFolder existing) {
  switch (existing) {
  case ExistingFolder::refuse:
    throw UserError(fmt::format("the output folder {} already holds files\n  = replace earlier "
                                "results with --overwrite, finish an interrupted run with "
                                "--resume, or choose another folder with -o",
                                folder.string()));
  case ExistingFolder::overwrite:
    require_own(folder, existing);
    remove_results(folder);
    return;
  case ExistingFolder::resume:
    require_own(folder, existing);
    return;
  }
}

} // namespace

void prepare_output_folder(const fs::path& folder, ExistingFolder existing) {
  create(folder);
  try {
    if (!fs::is_empty(folder)) {
      // Before anything is removed.
      if (existing != ExistingFolder::refuse) {
        require_writable(folder);
      }
      make_room(folder, existing);
    }
  } catch (const fs::filesystem_error& error) {
    throw UserError(fmt::format("the output folder {} cannot be made ready: {}\n  = choose another "
                                "folder with -o",
                                folder.string(), error.code().message()));
  }
  require_writable(folder);
}

} // namespace ionskin::results
