// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/reading/read_case.hpp"

#include "ionskin/base/files/read_text_file.hpp"
#include "ionskin/case/checks/check_case.hpp"
#include "ionskin/case/checks/check_crossbar.hpp"
#include "ionskin/case/checks/check_metal.hpp"
#include "ionskin/case/checks/check_prescribed.hpp"
#include "ionskin/case/checks/check_readout.hpp"
#include "ionskin/case/checks/check_slider.hpp"
#include "ionskin/case/checks/check_water.hpp"
#include "ionskin/case/document/edited_choice.hpp"
#include "ionskin/case/document/height_map_file.hpp"
#include "ionskin/case/document/materials.hpp"
#include "ionskin/case/document/missing_keys.hpp"
#include "ionskin/case/document/set_edit.hpp"
#include "ionskin/case/document/slider_list.hpp"
#include "ionskin/case/document/taxel_grid.hpp"
#include "ionskin/case/document/toml_walk.hpp"
#include "ionskin/case/document/waypoint_file.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/case/text/toml_limits.hpp"
#include "ionskin/case/text/toml_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string_view>
#include <utility>

namespace ionskin {

namespace {

namespace fs = std::filesystem;

// Makes the path of a file absolute, in the value and in the text, so that the case that is written
// with the results runs from any folder.
// @param name of the key in the text
void anchor_file(const CaseDocument& document, const std::string& name, std::string& file,
                 CaseText& text) {
  if (file.empty() || fs::path(file).is_absolute())
    return;
  const fs::path folder = fs::absolute(document.file).parent_path();
  file = (folder / file).lexically_normal().string();
  apply_set_edits(text, {name + "=" + file});
}

void anchor_files(const TomlText& values, std::size_t slider, CaseDocument& document,
                  CaseText& text) {
  const auto anchor = [&](const std::string& key, std::string& file) {
    anchor_file(document, listed_key(values, slider, key), file, text);
  };
  anchor("strain.file", document.input.strain.file);
  anchor("motion.file", document.input.motion.file);
  anchor("slider.profile", document.input.slider.profile);
}

void take_waypoints(Case& input) {
  Motion& motion = input.motion;
  if (motion.kind != MotionKind::waypoints)
    return;
  if (!motion.file.empty() && motion.waypoints.empty())
    motion.waypoints = read_waypoint_file(motion.file);
  if (!motion.waypoints.empty())
    input.slider.start = motion.waypoints.front().position;
}

void settle_slider(Slider& slider) {
  if (slider.size[0] == 0)
    slider.size = slider.underside()->whole_plan().value_or(slider.size);
  if (shapes::shape_row(slider.shape).takes_heights)
    slider.profile_heights = read_height_map(slider.profile);
}

// Sorts records in the order of the schema. Keys of one layer or material stay together, in the
// order of the file.
std::vector<ValueRecord> in_order_of_schema(std::vector<ValueRecord> records) {
  std::map<std::string, std::size_t> rank; // of keys, and of common beginnings of keys
  const auto group = [](const std::string& key) {
    const std::size_t end = std::min(key.find('['), key.starts_with("materials.") ? 9 : key.size());
    return key.substr(0, end + 1);
  };
  for (const SchemaRow& row : schema())
    rank.emplace(group(row.key), rank.size());
  std::vector<std::pair<std::size_t, std::size_t>> order; // rank, and index in the file
  for (const ValueRecord& record : records) {
    const auto known = rank.find(group(record.key));
    order.emplace_back(known == rank.end() ? rank.size() : known->second, order.size());
  }
  std::ranges::sort(order);
  std::vector<ValueRecord> sorted;
  for (const auto& [of_key, index] : order)
    sorted.push_back(std::move(records[index]));
  return sorted;
}

std::string values_text(const std::vector<ValueRecord>& records) {
  std::string text;
  for (const ValueRecord& record : records)
    text += fmt::format("{} = {} {}\n", record.key, record.value.text,
                        fmt::join(record.value.numbers, " "));
  return text;
}

std::vector<std::string> notes_on_former_keys(const CaseDocument& document) {
  std::vector<std::string> keys;
  for (const ValueRecord& record : document.records)
    if (const SchemaRow* row = find_row(key_pattern(record.key));
        record.place && row != nullptr && !row->has_effect)
      keys.push_back(record.key);
  if (keys.empty())
    return {};
  return {fmt::format("{} {} no effect any more: remove {}.", fmt::join(keys, ", "),
                      keys.size() == 1 ? "has" : "have", keys.size() == 1 ? "it" : "them")};
}

} // namespace

namespace {

/// Throws UserError if a file is that of a live skin.
void refuse_live_skin(const std::string& path) {
  constexpr std::string_view begin = "ionskin live skin";
  std::string bytes(begin.size(), '\0');
  if (std::filesystem::is_regular_file(path) &&
      std::ifstream(path, std::ios::binary)
          .read(bytes.data(), static_cast<std::streamsize>(bytes.size())) &&
      bytes == begin) {
    throw UserError(path +
                    " is a live skin, where a case file is wanted\n  = give the case; a live "
                    "skin is stepped in Python, C or an FMU, and ionskin generate makes "
                    "training data of it");
  }
}

} // namespace

CaseDocument read_case_document(const std::string& path,
                                const std::vector<std::string>& set_edits) {
  refuse_live_skin(path);
  return read_case_text(base::read_text_file(path, "case", toml_limits::bytes), path, set_edits);
}

namespace {

// Reads the keys of a case of one slider, and completes it with presets and defaults.
CaseDocument walk_document(const CaseText& text, const TomlText& values, const std::string& path,
                           const std::optional<EditedChoices>& choices,
                           const TomlWalk::Name& name) {
  Problems problems;
  TomlWalk walk(text, values, problems, name);
  walk.visit();
  complete_materials(walk, problems);
  complete(walk, path, choices, problems);
  resolve_materials(walk, problems);
  CaseDocument document(std::move(walk.draft.input), path,
                        in_order_of_schema(std::move(walk.records)));
  check_water_keys(document, problems);
  check_prescribed_keys(document, problems);
  problems.throw_if_any(path);
  return document;
}

// Sets the members of a case that follow from its keys: files, angles, the taxels of a grid.
void settle(Case& input) {
  if (input.strain.kind == StrainSourceKind::contact)
    settle_slider(input.slider);
  take_waypoints(input);
  settle_pose(input);
  if (input.readout.taxels.empty())
    input.readout.taxels = taxels_of(input.readout.taxel_grid, input.skin);
}

void add_notes(const std::optional<EditedChoices>& choices, CaseDocument& document) {
  if (choices && !choices->left_out.empty())
    document.input.notes.push_back(
        fmt::format("Without a meaning with {}, and left out of the case: {}.", choices->words,
                    fmt::join(choices->left_out, ", ")));
  for (auto* const notes : {notes_on_readout, notes_on_crossbar, notes_on_metal, notes_on_slider,
                            notes_on_former_keys}) {
    for (std::string& note : notes(document)) {
      document.input.notes.push_back(std::move(note));
    }
  }
}

} // namespace

CaseDocument read_case_text(const std::string& original, const std::string& path,
                            const std::vector<std::string>& set_edits) {
  CaseText text(path, original);
  TomlText values = apply_set_edits(text, set_edits);
  const std::size_t listed = listed_sliders(values);
  const std::optional<EditedChoices> choices =
      listed > 0 ? std::nullopt : fit_to_edited_choices(text, values, original, set_edits);
  std::vector<CaseDocument> documents;
  for (std::size_t i = 0; i < std::max<std::size_t>(1, listed); ++i) {
    documents.push_back(
        walk_document(text, listed > 0 ? with_slider(values, i) : values, path, choices,
                      [&](const std::string& key) { return listed_key(values, i, key); }));
  }
  for (std::size_t i = 0; i < documents.size(); ++i)
    anchor_files(values, i, documents[i], text);
  for (CaseDocument& document : documents) {
    settle(document.input);
    document.input.text = text.text();
    document.input.values = values_text(document.records);
    check_case(document);
  }
  add_notes(choices, documents.front());
  if (listed == 0)
    return std::move(documents.front());
  CaseDocument joined = joined_sliders(values, std::move(documents));
  joined.input.values = values_text(joined.records);
  return joined;
}

void check_values(const std::string& original, const std::string& name,
                  const std::vector<std::string>& set_edits) {
  CaseText text(name, original);
  const TomlText values = apply_set_edits(text, set_edits);
  const std::size_t listed = listed_sliders(values);
  for (std::size_t i = 0; i < std::max<std::size_t>(1, listed); ++i) {
    Problems problems;
    TomlWalk(text, listed > 0 ? with_slider(values, i) : values, problems, [&](const auto& key) {
      return listed_key(values, i, key);
    }).visit();
    problems.throw_if_any(name);
  }
}

Case read_case(const std::string& path, const std::vector<std::string>& set_edits) {
  return read_case_document(path, set_edits).input;
}

} // namespace ionskin
