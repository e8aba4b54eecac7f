// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/run_folder.hpp"

#include "ionskin/base/file_copy.hpp"
#include "ionskin/results/atomic_file.hpp"
#include "ionskin/results/output_folder.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

namespace ionskin::study {
namespace {

std::string waypoints_text(const Motion& motion) {
  std::string text;
  for (const Waypoint& waypoint : motion.waypoints) {
    text += fmt::format(" waypoint {} {} {} {}", waypoint.time, waypoint.position,
                        waypoint.height ? fmt::format("height {}", *waypoint.height) : "",
                        waypoint.force ? fmt::format("force {}", *waypoint.force) : "");
  }
  return text;
}

std::string heights_text(const HeightMap& map) {
  return fmt::format(" heights {} {} {}", map.x, map.y, map.height);
}

results::ExistingFolder existing_folder(const RunOptions& options) {
  if (options.overwrite) {
    return results::ExistingFolder::overwrite;
  }
  const bool takes_up = options.resume || options.studies == Studies::electrochemistry;
  return takes_up ? results::ExistingFolder::resume : results::ExistingFolder::refuse;
}

} // namespace

RunFolder::RunFolder(const Case& input, const RunOptions& options) : folder_(options.folder) {
  results::prepare_output_folder(folder_, existing_folder(options));
  manifest_ = results::new_manifest(options.command, options.threads, input_hash(input));
  const auto manifest_path = file(results::file_names::manifest);
  if ((options.resume || options.studies == Studies::electrochemistry) &&
      std::filesystem::exists(manifest_path)) {
    earlier_ = results::read_manifest(manifest_path);
  }
  if (options.resume && !earlier_.input_hash.empty() &&
      earlier_.input_hash != manifest_.input_hash) {
    throw UserError(
        fmt::format("{} holds the results of another case than the one to resume (it may differ "
                    "in a --set edit only): give the same case and edits, choose another folder, "
                    "or replace its results with --overwrite",
                    folder_.string()));
  }
  if (earlier_.input_hash != manifest_.input_hash) {
    earlier_.stages.erase("electrochemistry");
  }
  manifest_.stages = earlier_.stages;
  results::write_text_file(file(results::file_names::case_text), input.text);
  write_manifest();
}

bool RunFolder::was_finished(const std::string& stage) const {
  const auto found = earlier_.stages.find(stage);
  return found != earlier_.stages.end() && found->second.state == "finished";
}

void RunFolder::begin(const std::string& stage) {
  manifest_.stages[stage] = {"running", 0.0, 0.0};
  write_manifest();
}

void RunFolder::end(const std::string& stage, const std::string& state, double seconds) {
  manifest_.stages[stage] = {state, seconds, base::peak_memory()};
  if (state != "finished") {
    manifest_.state = state;
  }
  write_manifest();
}

void RunFolder::finish(bool sound) {
  manifest_.state = sound ? "finished" : "failed";
  write_manifest();
}

void RunFolder::write_manifest() const {
  results::write_manifest(file(results::file_names::manifest), manifest_);
}

std::string input_hash(const Case& input) {
  std::string text = input.text;
  if (!input.motion.file.empty()) {
    text += waypoints_text(input.motion);
  }
  if (!input.slider.profile.empty()) {
    text += heights_text(input.slider.profile_heights);
  }
  if (input.strain.kind == StrainSourceKind::file) {
    text += base::file_digest(input.strain.file).hex();
  }
  return results::content_hash(text);
}

std::string mechanics_hash(const Case& input) {
  // The record holds the companions of the errors; without them it is another one.
  std::string text = "companions mesh path thickness ";
  text += fmt::format("skin {} {} {}", input.skin.length, input.skin.width,
                      static_cast<int>(input.skin.sides));
  for (const Layer& layer : input.skin.layers) {
    text += fmt::format(" layer {} {} {} {}", static_cast<int>(layer.role), layer.thickness,
                        layer.material.youngs_modulus, layer.material.poissons_ratio);
  }
  const Motion& motion = input.motion;
  const Slider& slider = input.slider;
  text += fmt::format(" slider {} {} {} {} {}", static_cast<int>(slider.shape), slider.size,
                      slider.start, slider.edge_radius, slider.radius);
  text += heights_text(slider.profile_heights);
  text += fmt::format(" motion {} {} {} {} {} {} {} {} {} {}", static_cast<int>(motion.kind),
                      motion.gap, motion.preload, motion.stroke, motion.direction, motion.touchdown,
                      motion.slide, motion.lift, motion.return_, motion.cycles);
  text +=
      fmt::format(" force {} strokes {} {}", motion.preload_force, motion.strokes, motion.dwell);
  text += waypoints_text(motion);
  text += fmt::format(" contact {} {} measure {}", input.contact.law, input.contact.friction,
                      static_cast<int>(input.coupling.measure));
  text += fmt::format(" numerics {} {} {}", static_cast<int>(input.numerics.preset),
                      input.numerics.mesh_refinement, input.numerics.time_refinement);
  // Field instants within the slide are samples of the strain history.
  text += fmt::format(" fields {}", fmt::join(input.output.fields, " "));
  return results::content_hash(text);
}

} // namespace ionskin::study
