// SPDX-License-Identifier: Apache-2.0
#include "study_verbs/live.hpp"

#include "command_line/threads.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/system/installation.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/base/system/own_build.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/live/errors/shortfall.hpp"
#include "ionskin/live/fmu/archive.hpp"
#include "ionskin/live/training/touch_events.hpp"
#include "ionskin/live/training/train.hpp"
#include "ionskin/planning/resources.hpp"
#include "ionskin/results/manifest.hpp"
#include "ionskin/study/run/run_folder.hpp"
#include "terminal/progress_display.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ionskin::apps {
namespace {

constexpr const char *output_option = "--output", *fmu_option = "--fmu";

/// Requires, before hours of work, that a file can be written. Throws UserError.
void require_writable(const char* option, const std::filesystem::path& file, bool overwrite) {
  std::error_code failure;
  if (std::filesystem::is_directory(file, failure)) {
    throw UserError(fmt::format("{} {}: is a folder\n  = name a file, such as skin.{}", option,
                                file.string(), option == output_option ? "live" : "fmu"));
  }
  if (!overwrite && std::filesystem::exists(std::filesystem::symlink_status(file, failure))) {
    throw UserError(fmt::format("{} {}: the file is there already\n  = add --overwrite to "
                                "replace it, or name another",
                                option, file.string()));
  }
  const auto folder = std::filesystem::absolute(file).parent_path();
  if (!std::filesystem::is_directory(folder, failure)) {
    throw UserError(fmt::format("{} {}: there is no folder {}\n  = make it first", option,
                                file.string(), folder.string()));
  }
  base::PendingFile{file}; // removed at once
}

void require_outputs(const LiveOptions& options) {
  if (options.output.empty() && options.fmu.empty()) {
    throw UserError("live: no file to write is named\n  = add --output skin.live, --fmu skin.fmu, "
                    "or both");
  }
  if (!options.fmu.empty() && std::filesystem::path(options.fmu).extension() != ".fmu") {
    throw UserError(fmt::format("--fmu {}: the name must end in .fmu, by which importers know it",
                                options.fmu));
  }
  for (const auto& [option, file] :
       {std::pair{output_option, options.output}, std::pair{fmu_option, options.fmu}}) {
    if (!file.empty()) {
      require_writable(option, file, options.overwrite);
    }
  }
  if (!options.fmu.empty() && std::filesystem::path(options.output).lexically_normal() ==
                                  std::filesystem::path(options.fmu).lexically_normal()) {
    throw UserError("--output and --fmu name the same file");
  }
}

/// Prints a warning where the reported errors are larger than promised, even where the log is
/// quiet.
void warn_of_shortfall(const ionskin::live::SkinData& data) {
  const std::string line = ionskin::live::shortfall(data);
  if (!line.empty()) {
    fmt::print(stderr, "warning: {}\n", line);
  }
}

void write_files(const LiveOptions& options, const ionskin::live::SkinData& data) {
  const auto tell = [&](const char* what, const std::string& file) {
    if (options.log != LogFormat::quiet) {
      fmt::print("{}: {} ({:.1f} MB)\n", what, file,
                 static_cast<double>(std::filesystem::file_size(file)) / 1e6);
    }
  };
  if (!options.output.empty()) {
    ionskin::live::write_skin(options.output, data);
    tell("live skin", options.output);
  }
  if (!options.fmu.empty()) {
    ionskin::live::fmu::write_fmu(options.fmu, data,
                                  base::own_file().parent_path() / "ionskin_live_fmu.so");
    tell("FMU", options.fmu);
  }
  warn_of_shortfall(data);
}

/// File that keeps what is done of a training, beside the first of its outputs.
std::filesystem::path record_of(const LiveOptions& options) {
  return (options.output.empty() ? options.fmu : options.output) + ".unfinished";
}

/// Requires that no finished part of a training is lost. Throws UserError.
void require_no_record(const std::filesystem::path& record) {
  std::error_code failure;
  if (std::filesystem::exists(std::filesystem::symlink_status(record, failure))) {
    throw UserError(fmt::format("{}: an interrupted training is kept here\n"
                                "  = add --resume to go on with it, or --overwrite to train anew",
                                record.string()));
  }
}

/// Digest of everything that decides the result of a training.
std::string identity_of(const Case& input, const LiveOptions& options) {
  const std::array<double, 2> friction = options.friction.value_or(std::array<double, 2>{});
  return results::content_hash(
      fmt::format("{} {} {} {} {} {} {} {} {} {}", study::input_hash(input),
                  base::own_build() ? base::own_build()->hex() : "", options.trajectories,
                  options.validation, options.seed, friction[0], friction[1], options.tilt,
                  options.spin, options.slider.value_or(0)));
}

/// Writes an FMU of a skin that was trained before. Returns the exit code.
int export_skin(const LiveOptions& options) {
  if (options.trains) {
    throw UserError(fmt::format(
        "{} is a live skin, trained already: --output, --set, "
        "--trajectories, --friction, --tilt, --spin, --slider, --validation, --seed and "
        "--resume have no use\n  = give --fmu alone, or "
        "the case file to train anew",
        options.case_path));
  }
  write_files(options, ionskin::live::read_skin(options.case_path));
  return static_cast<int>(ExitCode::success);
}

/// The case of one slider of a list, alone on the skin; any other case as it is.
Case case_of_slider(const Case& input, std::optional<int> number) {
  if (!number) {
    return input;
  }
  const std::vector<Case> sliders = cases_of_sliders(input);
  if (*number < 1 || *number > static_cast<int>(sliders.size())) {
    throw UserError(fmt::format("--slider {}: the case has {} slider{}, counted from 1", *number,
                                sliders.size(), sliders.size() == 1 ? "" : "s"));
  }
  return sliders[static_cast<std::size_t>(*number - 1)];
}

/// Prints the range of motion within which the skin was trained.
void print_range(const ionskin::live::SkinData& data) {
  const auto range = [](double low, double high) {
    return low == high ? fmt::format("{:.4g} mm only", low * 1e3)
                       : fmt::format("{:.4g} to {:.4g} mm", low * 1e3, high * 1e3);
  };
  fmt::print("trained for x {}, y {}, up to {:.3g} N, {:.3g} um deep, {:.3g} mm/s\n",
             range(data.lowest_place[0], data.highest_place[0]),
             range(data.lowest_place[1], data.highest_place[1]), data.heaviest_force,
             data.deepest_indentation * 1e6, data.fastest * 1e3);
  if (data.highest_friction > data.lowest_friction) {
    fmt::print("friction {:g} to {:g}\n", data.lowest_friction, data.highest_friction);
  }
  if (data.steepest > 0 || data.fastest_turn > 0) {
    constexpr double degrees = 180 / std::numbers::pi;
    fmt::print("tilted up to {:.3g} degrees, turned by up to {:.3g} degrees a second\n",
               data.steepest * degrees, data.fastest_turn * degrees);
  }
}

/// @param touches number of unseen touches
void print_errors(const ionskin::live::SkinData& data, std::size_t touches) {
  // The largest error of n touches is exceeded by at most a share s of all touches with the
  // confidence 1 - (1 - s)^n (Wilks 1941, doi 10.1214/aoms/1177731788).
  constexpr double share = 0.05, few = 0.9;
  const double confidence = 1 - std::pow(1 - share, static_cast<double>(touches));
  fmt::print("errors on {} unseen touches, of the largest value; they hold for 95 % of all touches "
             "with a confidence of {:.0f} %{}:\n",
             touches, 100 * confidence, confidence < few ? " (--validation 45 gives 90 %)" : "");
  std::map<std::string, std::map<std::string, double>> by_event; // rms in per cent, by signal
  for (const ionskin::live::SignalError& error : data.errors) {
    if (error.largest > 0 && error.event.empty()) {
      fmt::print("{:<28} {:8.3f} % rms {:8.3f} % at worst\n", error.name,
                 100 * error.rms / error.largest, 100 * error.worst / error.largest);
    } else if (error.largest > 0) {
      by_event[error.name][error.event] = 100 * error.rms / error.largest;
    }
  }
  fmt::print("rms errors over events, of the largest value within such events:\n{:<28}", "");
  for (const char* event : ionskin::live::event::names) {
    fmt::print(" {:>12}", event);
  }
  fmt::print("\n");
  for (const auto& [name, errors] : by_event) {
    fmt::print("{:<28}", name);
    for (const char* event : ionskin::live::event::names) {
      const auto error = errors.find(event);
      fmt::print(" {:>12}", error == errors.end() ? "" : fmt::format("{:.3f} %", error->second));
    }
    fmt::print("\n");
  }
}

} // namespace

int live(const LiveOptions& options, const std::string& command) {
  base::install_interrupt_handler();
  if (ionskin::live::is_skin_file(options.case_path)) {
    require_outputs(options);
    return export_skin(options);
  }
  const Case input =
      case_of_slider(read_case(options.case_path, options.set_edits), options.slider);
  require_outputs(options);
  ionskin::live::TrainingOptions settings;
  settings.friction = options.friction;
  settings.tilt = options.tilt * std::numbers::pi / 180;
  settings.turn = options.spin * std::numbers::pi / 180;
  ionskin::live::check_trainable(input, settings);
  planning::require_resources(input, thread_count(options.threads));
  const std::filesystem::path record = record_of(options);
  std::error_code failure;
  if (options.overwrite) {
    std::filesystem::remove(record, failure);
  } else if (!options.resume) {
    require_no_record(record);
  }
  ionskin::live::SkinData data;
  bool interrupted = false;
  {
    ProgressDisplay display(options.log);
    settings.trajectories = options.trajectories;
    settings.validation = options.validation;
    settings.seed = options.seed;
    settings.threads = thread_count(options.threads);
    settings.progress = display.callback();
    settings.command = command;
    settings.record = record;
    settings.identity = identity_of(input, options);
    settings.resume = options.resume;
    try {
      data = ionskin::live::train_skin(input, settings);
    } catch (const Interrupted&) {
      interrupted = true;
    }
  }
  if (interrupted) {
    fmt::print(stderr, "interrupted: {} was not written{}\n",
               options.output.empty() ? options.fmu : options.output,
               std::filesystem::exists(record, failure)
                   ? "; the trained skin and the touches that were compared are kept in " +
                         record.string() + ": --resume continues"
                   : "");
    return static_cast<int>(ExitCode::interrupted);
  }
  if (options.log != LogFormat::quiet) {
    print_range(data);
    print_errors(data, options.validation);
  }
  write_files(options, data);
  std::filesystem::remove(record, failure);
  return static_cast<int>(ExitCode::success);
}

} // namespace ionskin::apps
