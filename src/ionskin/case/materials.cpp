// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/materials.hpp"

#include "ionskin/base/nearest_name.hpp"
#include "ionskin/case/data_folder.hpp"
#include "ionskin/case/read_text_file.hpp"
#include "ionskin/case/toml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace ionskin {

namespace {

namespace fs = std::filesystem;

fs::path materials_folder() {
  return data_folder() / "materials";
}

// Values of a preset that the case does not give itself.
void complete_from_preset(const std::string& name, TomlWalk& walk, Problems& problems) {
  const fs::path file = materials_folder() / (name + ".toml");
  const CaseText text(file.string(), read_text_file(file.string(), "material preset"));
  TomlWalk preset(text, problems);
  preset.visit(parse_toml(text.text(), text.file()));
  Material& material = walk.draft.materials[name];
  material.name = name;
  const Material& installed = preset.draft.materials[name];
  for (ValueRecord record : preset.records) {
    if (!record.key.starts_with("materials." + name + ".") || walk.seen[record.key])
      continue;
    walk.seen[record.key] = true;
    record.origin = ValueOrigin::preset;
    walk.records.push_back(record);
    if (record.key.ends_with(".youngs_modulus"))
      material.youngs_modulus = installed.youngs_modulus;
    if (record.key.ends_with(".poissons_ratio"))
      material.poissons_ratio = installed.poissons_ratio;
  }
}

std::string quoted_list(const std::set<std::string>& names) {
  std::string list;
  for (const std::string& name : names)
    list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", name);
  return list;
}

void report_unknown(const std::string& name, const std::vector<Pointer>& where,
                    const TomlWalk& walk, const std::vector<std::string>& presets,
                    Problems& problems) {
  std::set<std::string> known(presets.begin(), presets.end());
  for (const auto& [defined, material] : walk.draft.materials)
    known.insert(defined);
  const std::string nearest = base::nearest_name(name, {known.begin(), known.end()});
  const std::string hint = nearest.empty() ? "" : fmt::format("did you mean \"{}\"? ", nearest);
  problems.add(fmt::format("unknown material \"{}\"", name), where,
               fmt::format("{}known: {}; or define it in a section [materials.{}]", hint,
                           quoted_list(known), name));
}

std::vector<Pointer> place_of_layer_material(const TomlWalk& walk, std::size_t layer) {
  const std::string key = fmt::format("skin.layers[{}].material", layer);
  for (const ValueRecord& record : walk.records)
    if (record.key == key && record.place)
      return {{*record.place, ""}};
  return {};
}

void report_missing(const std::string& name, TomlWalk& walk, Problems& problems) {
  for (const char* property : {"youngs_modulus", "poissons_ratio"}) {
    const std::string key = fmt::format("materials.{}.{}", name, property);
    if (walk.seen[key])
      continue;
    problems.add("missing key " + key, {{walk.tables["materials." + name], ""}},
                 std::string("add it: ") +
                     (property[0] == 'y' ? "\"1 GPa\", say" : "a number below 0.5"));
  }
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

void resolve_materials(TomlWalk& walk, Problems& problems) {
  const std::vector<std::string> presets = installed_materials();
  std::vector<Layer>& layers = walk.draft.input.skin.layers;
  std::set<std::string> done;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::string name = layers[i].material.name;
    if (name.empty())
      continue; // reported as a missing or bad key
    const bool defined = walk.draft.materials.contains(name);
    const bool preset = std::find(presets.begin(), presets.end(), name) != presets.end();
    if (!defined && !preset) {
      report_unknown(name, place_of_layer_material(walk, i), walk, presets, problems);
      continue;
    }
    if (done.insert(name).second) {
      if (preset)
        complete_from_preset(name, walk, problems);
      report_missing(name, walk, problems);
    }
    layers[i].material = walk.draft.materials[name];
  }
}

} // namespace ionskin
