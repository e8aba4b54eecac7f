// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/document/materials.hpp"

#include "ionskin/base/files/read_text_file.hpp"
#include "ionskin/base/nearest_name.hpp"
#include "ionskin/base/text.hpp"
#include "ionskin/case/coupling.hpp"
#include "ionskin/case/document/over_humidity.hpp"
#include "ionskin/case/text/data_folder.hpp"
#include "ionskin/case/text/toml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <utility>

namespace ionskin {

namespace {

namespace fs = std::filesystem;

fs::path materials_folder() {
  return data_folder() / "materials";
}

std::string key_of(const std::string& material, const std::string& property) {
  return fmt::format("materials.{}.{}", material, property);
}

// Takes the values that the case does not give itself from the installed preset of a material.
void complete_from_preset(const std::string& name, TomlWalk& walk, Problems& problems) {
  const fs::path file = materials_folder() / (name + ".toml");
  const CaseText text(file.string(), base::read_text_file(file.string(), "material preset"));
  const TomlText values(text.text(), text.file());
  TomlWalk preset(text, values, problems);
  preset.visit();
  walk.draft.materials[name]; // the name is known, even if the preset gives no value
  for (ValueRecord record : preset.records) {
    if (!record.key.starts_with(key_of(name, "")) || walk.seen[record.key])
      continue;
    walk.seen[record.key] = true;
    record.origin = ValueOrigin::preset;
    find_row(key_pattern(record.key))->set(walk.draft, {0, name}, record.value);
    walk.records.push_back(record);
  }
}

// True if the case gives this key or an alternative to it, one with the same purpose.
bool is_told_otherwise(const SchemaRow& row, const TomlWalk& walk) {
  return !row.purpose.empty() && std::ranges::any_of(schema(), [&](const SchemaRow& other) {
    const auto seen = walk.seen.find(other.key);
    return other.purpose == row.purpose && seen != walk.seen.end() && seen->second;
  });
}

// Takes properties of ions and water that the case does not give from the material of the core.
void take_ions(const std::string& material, TomlWalk& walk) {
  for (const SchemaRow& row : schema()) {
    const bool applies = !row.applies || row.applies(walk.draft.input);
    if (!row.of_material || !applies || walk.seen[row.key] || is_told_otherwise(row, walk))
      continue;
    const std::string source = key_of(material, row.key.substr(row.key.find('.') + 1));
    walk.seen[row.key] = walk.seen[source];
    const auto known = std::ranges::find(walk.records, source, &ValueRecord::key);
    if (known == walk.records.end())
      continue; // not given, or a bad value, which is already reported
    ValueRecord record = *known;
    record.key = row.key;
    row.set(walk.draft, {}, record.value);
    walk.records.push_back(std::move(record));
  }
}

std::string quoted_list(const std::set<std::string>& names) {
  std::string list;
  for (const std::string& name : names)
    list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", name);
  return list;
}

/// A name as a key of TOML, in quotation marks unless it is a bare key.
std::string toml_key(const std::string& name) {
  const bool bare = !name.empty() && std::ranges::all_of(name, [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_' || letter == '-';
  });
  return bare ? name : fmt::format("\"{}\"", name);
}

void report_unknown(const std::string& name, const std::vector<Pointer>& where,
                    const TomlWalk& walk, const std::vector<std::string>& presets,
                    Problems& problems) {
  if (problems.full()) {
    problems.add("", {}, ""); // only counted: the lists of names would not be shown
    return;
  }
  std::set<std::string> known(presets.begin(), presets.end());
  for (const auto& [defined, material] : walk.draft.materials)
    known.insert(defined);
  const std::string nearest = base::nearest_name(name, {known.begin(), known.end()});
  const std::string hint = nearest.empty() ? "" : fmt::format("did you mean \"{}\"? ", nearest);
  problems.add(fmt::format("unknown material \"{}\"", base::shown(name)), where,
               fmt::format("{}known: {}; or define it in a section [materials.{}]", hint,
                           quoted_list(known), toml_key(base::shown(name))));
}

std::vector<Pointer> place_of_layer_material(const TomlWalk& walk, std::size_t layer) {
  const std::string key = fmt::format("skin.layers[{}].material", layer);
  for (const ValueRecord& record : walk.records)
    if (record.key == key && record.place)
      return {{*record.place, ""}};
  return {};
}

void report_missing(const std::string& name, std::size_t layer, TomlWalk& walk,
                    Problems& problems) {
  for (const char* property : {"youngs_modulus", "poissons_ratio"}) {
    const std::string key = key_of(name, property);
    if (walk.seen[key])
      continue;
    const auto table = walk.tables.find("materials." + name);
    const bool in_case = table != walk.tables.end();
    problems.add(
        "missing key " + key,
        in_case ? std::vector<Pointer>{{table->second, ""}} : place_of_layer_material(walk, layer),
        fmt::format("{}: {}", in_case ? "add it" : "the preset leaves it out; add it to the case",
                    property[0] == 'y' ? "\"1 GPa\", say" : "a number below 0.5"));
  }
}

bool needs_stiffness(const Case& input, const Layer& layer) {
  return input.strain.kind == StrainSourceKind::contact ||
         (moves_water(input) && layer.role == LayerRole::core);
}

} // namespace

std::vector<std::string> installed_materials() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(materials_folder(), error))
    if (entry.path().extension() == ".toml")
      names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

void complete_materials(TomlWalk& walk, Problems& problems) {
  const std::vector<std::string> presets = installed_materials();
  std::set<std::string> done;
  bool follows_humidity = false;
  for (const Layer& layer : walk.draft.input.skin.layers) {
    const std::string& name = layer.material.name;
    if (done.insert(name).second) {
      if (std::ranges::find(presets, name) != presets.end())
        complete_from_preset(name, walk, problems);
      follows_humidity = settle_humidity(name, walk, problems) || follows_humidity;
    }
    if (layer.role == LayerRole::core)
      take_ions(name, walk);
  }
  if (!follows_humidity)
    refuse_humidity(walk, problems);
}

void resolve_materials(TomlWalk& walk, Problems& problems) {
  std::vector<Layer>& layers = walk.draft.input.skin.layers;
  std::set<std::string> done;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (!needs_stiffness(walk.draft.input, layers[i]))
      continue;
    const std::string name = layers[i].material.name;
    const std::string key = fmt::format("skin.layers[{}].material", i);
    if (name.empty()) {
      if (!walk.seen[key] && walk.draft.input.strain.kind != StrainSourceKind::contact)
        problems.add("missing key " + key +
                         ": the law \"poroelastic\" takes the elastic constants "
                         "of the core from it",
                     {}, "add it: \"nafion\", say");
      continue; // else already reported as a missing or bad key
    }
    if (!walk.draft.materials.contains(name)) {
      report_unknown(name, place_of_layer_material(walk, i), walk, installed_materials(), problems);
      continue;
    }
    if (done.insert(name).second)
      report_missing(name, i, walk, problems);
    layers[i].material = walk.draft.materials[name];
    layers[i].material.name = name;
  }
}

} // namespace ionskin
