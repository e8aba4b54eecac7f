// SPDX-License-Identifier: Apache-2.0
#include "study_verbs/live.hpp"

#include "command_line/threads.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/live/training/train.hpp"
#include "ionskin/planning/resources.hpp"
#include "ionskin/study/run/user_cache.hpp"
#include "terminal/progress_display.hpp"

#include <fmt/core.h>

#include <filesystem>

namespace ionskin::apps {
namespace {

/// Before hours of work.
void require_writable(const std::filesystem::path& file, bool overwrite) {
  std::error_code failure;
  if (std::filesystem::is_directory(file, failure)) {
    throw UserError(
        fmt::format("--output {}: is a folder\n  = name a file, such as skin.live", file.string()));
  }
  if (!overwrite && std::filesystem::exists(std::filesystem::symlink_status(file, failure))) {
    throw UserError(fmt::format("--output {}: the file is there already\n  = add --overwrite to "
                                "replace it, or name another",
                                file.string()));
  }
  const auto folder = std::filesystem::absolute(file).parent_path();
  if (!std::filesystem::is_directory(folder, failure)) {
    throw UserError(fmt::format("--output {}: there is no folder {}\n  = make it first",
                                file.string(), folder.string()));
  }
  base::PendingFile{file}; // removed at once
}

void print_errors(const ionskin::live::SkinData& data) {
  fmt::print("errors on unseen touches, of the largest value:\n");
  for (const ionskin::live::SignalError& error : data.errors) {
    if (error.largest > 0 && error.name.find("charge_top_") == std::string::npos) {
      fmt::print("{:<28} {:8.3f} % rms {:8.3f} % at worst\n", error.name,
                 100 * error.rms / error.largest, 100 * error.worst / error.largest);
    }
  }
}

} // namespace

int live(const LiveOptions& options, const std::string& command) {
  base::install_interrupt_handler();
  const Case input = read_case(options.case_path, options.set_edits);
  require_writable(options.output, options.overwrite);
  ionskin::live::check_trainable(input);
  planning::require_resources(input, thread_count(options.threads));
  study::RunOptions cache_options;
  cache_options.use_cache = options.use_cache;
  const auto cache = study::open_user_cache(cache_options);
  ionskin::live::SkinData data;
  bool interrupted = false;
  {
    ProgressDisplay display(options.log);
    ionskin::live::TrainingOptions settings;
    settings.trajectories = options.trajectories;
    settings.seed = options.seed;
    settings.threads = thread_count(options.threads);
    settings.cache = cache.get();
    settings.progress = display.callback();
    settings.command = command;
    try {
      data = ionskin::live::train_skin(input, settings);
    } catch (const Interrupted&) {
      interrupted = true;
    }
  }
  if (interrupted) { // unlike a run, it keeps nothing to go on from
    fmt::print(stderr, "interrupted: {} was not written\n", options.output);
    return static_cast<int>(ExitCode::interrupted);
  }
  ionskin::live::write_skin(options.output, data);
  if (options.log != LogFormat::quiet) {
    print_errors(data);
    fmt::print("live skin: {} ({:.1f} MB)\n", options.output,
               static_cast<double>(std::filesystem::file_size(options.output)) / 1e6);
  }
  return static_cast<int>(ExitCode::success);
}

} // namespace ionskin::apps
