// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/run/run_folder.hpp"

#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/files/file_copy.hpp"
#include "ionskin/base/files/read_text_file.hpp"
#include "ionskin/base/files/sealed_file.hpp"
#include "ionskin/base/system/own_build.hpp"
#include "ionskin/case/coupling.hpp"
#include "ionskin/results/file_list.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>

namespace ionskin::study {
namespace {

std::string waypoints_text(const Motion& motion) {
  std::string text;
  for (const Waypoint& waypoint : motion.waypoints) {
    text += fmt::format(" waypoint {} {} {} {}", waypoint.time, waypoint.position,
                        waypoint.height ? fmt::format("height {}", *waypoint.height) : "",
                        waypoint.force ? fmt::format("force {}", *waypoint.force) : "");
    const auto add_angle = [&](const char* name, const std::optional<double>& angle) {
      text += angle ? fmt::format(" {} {}", name, *angle) : "";
    };
    add_angle("roll", waypoint.roll);
    add_angle("pitch", waypoint.pitch);
    add_angle("yaw", waypoint.yaw);
  }
  return text;
}

std::string heights_text(const shapes::HeightMap& map) {
  return fmt::format(" heights {} {} {}", map.x, map.y, map.height);
}

/// Study 2 alone needs the Study 1 of its folder: nothing is removed before it is read.
results::ExistingFolder existing_folder(const RunOptions& options) {
  if (options.resume || options.studies == Studies::electrochemistry) {
    return results::ExistingFolder::resume;
  }
  return options.overwrite ? results::ExistingFolder::overwrite : results::ExistingFolder::refuse;
}

/// True if a manifest says that this build of the program finished the case with this hash, and all
/// its result files are unchanged.
bool is_whole(const results::Manifest& manifest, const std::string& hash,
              const std::filesystem::path& folder) {
  const auto& files = manifest.files;
  return manifest.state == "finished" && manifest.input_hash == hash && base::own_build() &&
         manifest.build == base::own_build()->hex() && !files.empty() &&
         std::all_of(files.begin(), files.end(), [&](const auto& entry) {
           const auto digest = results::is_inner_name(entry.first)
                                   ? base::digest_if_readable(folder / entry.first)
                                   : std::nullopt;
           return digest && digest->hex() == entry.second;
         });
}

/// Text of everything about a slider, its motion and its contact that decides Study 1.
std::string slider_text(const Slider& slider, const Motion& motion, const Contact& contact) {
  std::string text = fmt::format(" slider {} {} {}", slider.shape, slider.size, slider.start);
  text += fmt::format(" pose {} {} {}", slider.pose.roll, slider.pose.pitch, slider.pose.yaw);
  for (const auto& [name, value] : slider.parameters) {
    text += fmt::format(" {} {}", name, value);
  }
  text += heights_text(slider.profile_heights);
  text += fmt::format(" gives {} {} {}", slider.youngs_modulus, slider.poissons_ratio,
                      slider.pad_thickness);
  text += fmt::format(" motion {} {} {} {} {} {} {} {} {} {}", static_cast<int>(motion.kind),
                      motion.gap, motion.preload, motion.stroke, motion.direction, motion.touchdown,
                      motion.slide, motion.lift, motion.return_, motion.cycles);
  text +=
      fmt::format(" force {} strokes {} {}", motion.preload_force, motion.strokes, motion.dwell);
  text += waypoints_text(motion);
  if (const Drive& drive = motion.drive; drive.stiffness + drive.damping + drive.mass > 0) {
    text += fmt::format(" drive {} {} {}", drive.stiffness, drive.damping, drive.mass);
  }
  text += fmt::format(" contact {} {}", contact.law, contact.friction);
  for (const auto& [name, value] : contact.parameters) {
    text += fmt::format(" {} {}", name, value);
  }
  return text;
}

} // namespace

RunFolder::RunFolder(const Case& input, const RunOptions& options)
    : folder_(options.folder, existing_folder(options),
              options.beside_others ? results::LockKind::shared : results::LockKind::exclusive) {
  manifest_ = results::new_manifest(options.command, options.threads, input_hash(input));
  if (options.resume || options.studies == Studies::electrochemistry) {
    take_up(input);
  }
  if (options.resume && !earlier_.input_hash.empty() &&
      earlier_.input_hash != manifest_.input_hash) {
    throw UserError(
        fmt::format("{} holds the results of another case than the one to resume (it may differ "
                    "in a --set edit or in a material preset only): give the same case and edits, "
                    "choose another folder, or replace its results with --overwrite",
                    path().string()));
  }
  if (earlier_.input_hash != manifest_.input_hash || options.overwrite) {
    earlier_.stages.erase("electrochemistry");
    earlier_.files.clear(); // not complete
  }
  manifest_.stages = earlier_.stages;
  base::write_text_file(own(results::file_names::case_text), input.text);
  complete_ = has_all_results();
  if (complete_) {
    manifest_ = earlier_;
  }
  write_manifest();
}

void RunFolder::take_up(const Case& input) {
  const auto manifest_path = file(results::file_names::manifest);
  if (!std::filesystem::exists(manifest_path)) {
    return;
  }
  try {
    earlier_ = results::read_manifest(manifest_path);
  } catch (const UserError&) {
    // Without a hash, only the text of the case tells which case was here.
    const auto text_path = file(results::file_names::case_text);
    if (std::filesystem::exists(text_path) &&
        base::read_text_file(text_path.string(), "case") != input.text) {
      throw;
    }
    note("manifest.json was damaged or is of an earlier version: only what proves to be whole is "
         "taken up.");
    earlier_.input_hash = manifest_.input_hash;
    return;
  }
  if (earlier_.build != manifest_.build || manifest_.build.empty()) {
    note("Another build of ionskin began this run: everything is done again.");
    earlier_.stages.clear();
    earlier_.files.clear();
  }
}

bool RunFolder::was_finished(const std::string& stage) const {
  const auto found = earlier_.stages.find(stage);
  return found != earlier_.stages.end() && found->second.state == "finished";
}

bool RunFolder::holds(const char* name) {
  const base::SealState state = base::check_seal(file(name));
  if (state == base::SealState::damaged) {
    note(fmt::format("{} was damaged: what it held is done again.", name));
  }
  return state == base::SealState::whole;
}

bool RunFolder::has_all_results() const {
  return is_whole(earlier_, manifest_.input_hash, path());
}

bool holds_finished_run(const std::filesystem::path& folder, const std::string& hash,
                        Studies studies) {
  const auto path = folder / results::file_names::manifest;
  if (!results::is_ionskin_manifest(path)) {
    return false;
  }
  try {
    const results::Manifest manifest = results::read_manifest(path);
    const auto ions = manifest.stages.find("electrochemistry");
    const bool both = ions != manifest.stages.end() && ions->second.state == "finished";
    return (both || studies == Studies::mechanics) && is_whole(manifest, hash, folder);
  } catch (const UserError&) {
    return false; // damaged: the run itself will report it
  }
}

void RunFolder::note(const std::string& text) {
  notes_.push_back(text);
}

void RunFolder::begin(const std::string& stage) {
  manifest_.state = "running";
  manifest_.files.clear();
  manifest_.stages[stage] = {"running", 0.0, 0.0, ""};
  write_manifest();
}

void RunFolder::add_finished(const std::string& stage, double seconds, const std::string& source) {
  manifest_.stages[stage].source = source;
  end(stage, "finished", seconds);
}

void RunFolder::keep_finished(const std::string& stage) {
  add_finished(stage, was_finished(stage) ? earlier_.stages.at(stage).wall_time : 0.0,
               "earlier run");
}

void RunFolder::end(const std::string& stage, const std::string& state, double seconds) {
  results::StageRecord& record = manifest_.stages[stage];
  record = {state, seconds, base::peak_memory(), record.source};
  if (state != "finished") {
    manifest_.state = state;
  }
  write_manifest();
}

void RunFolder::give_up(const std::string& stage, const std::string& state, double seconds) {
  try {
    end(stage, state, seconds);
  } catch (const base::UnwritableFile&) {
  }
}

void RunFolder::finish(bool sound) {
  // No digests of files that Python can draw again, nor of the checkpoint, which is removed.
  namespace names = results::file_names;
  const std::set<std::string> others{names::manifest, names::report, names::checkpoint};
  for (const std::string& name : folder_.owned()) {
    const auto digest = base::digest_if_readable(folder_.file(name));
    if (digest && others.count(name) == 0 && !name.starts_with(names::figures)) {
      manifest_.files[name] = digest->hex();
    }
  }
  manifest_.state = sound ? "finished" : "failed";
  write_manifest();
}

void RunFolder::fail(const std::string& reason) {
  manifest_.reason = reason;
  set_state("failed");
}

void RunFolder::set_state(const std::string& state) {
  manifest_.state = state;
  write_manifest();
}

void RunFolder::write_manifest() {
  results::write_manifest(own(results::file_names::manifest), manifest_);
}

std::string input_hash(const Case& input) {
  std::string text = input.text + input.values;
  for (const Case& slider : cases_of_sliders(input)) {
    if (!slider.motion.file.empty()) {
      text += waypoints_text(slider.motion);
    }
    if (!slider.slider.profile.empty()) {
      text += heights_text(slider.slider.profile_heights);
    }
  }
  if (input.strain.kind == StrainSourceKind::file) {
    text += base::file_digest(input.strain.file).hex();
  }
  return results::content_hash(text);
}

std::string mechanics_hash(const Case& input) {
  // With an error estimate the record also holds the coarser solutions, so its hash differs.
  std::string text = input.numerics.error_estimate ? "companions mesh path thickness " : "";
  text += "signals area stick slip moment ";
  text += fmt::format("skin {} {} {}", input.skin.length, input.skin.width,
                      static_cast<int>(input.skin.sides));
  for (const Layer& layer : input.skin.layers) {
    text += fmt::format(" layer {} {} {} {}", static_cast<int>(layer.role), layer.thickness,
                        layer.material.youngs_modulus, layer.material.poissons_ratio);
  }
  text += slider_text(input.slider, input.motion, input.contact);
  for (const FurtherSlider& further : input.further_sliders) {
    text += slider_text(further.slider, further.motion, further.contact);
  }
  text += " measure " + input.coupling.measure;
  // With water, the strain history has another grid and more channels.
  if (moves_water(input)) {
    text += " water";
  }
  text += fmt::format(" numerics {} {} {}", static_cast<int>(input.numerics.preset),
                      input.numerics.mesh_refinement, input.numerics.time_refinement);
  // Instants of fields within the slide are samples of the strain history.
  text += fmt::format(" fields {}", fmt::join(input.output.fields, " "));
  return results::content_hash(text);
}

} // namespace ionskin::study
