// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/checks/check_slider.hpp"

#include "ionskin/case/checks/check_pose.hpp"
#include "ionskin/case/schema/schema_laws.hpp"

#include <fmt/format.h>

namespace ionskin {

namespace {

std::vector<Pointer> places(const CaseDocument& document, const std::vector<std::string>& keys) {
  std::vector<Pointer> all;
  for (const std::string& key : keys)
    for (const Pointer& pointer : document.point_at(key))
      all.push_back(pointer);
  return all;
}

/// Refuses keys that only other shapes have. A parameter of 0 counts as not given.
void check_foreign_keys(const CaseDocument& document, Problems& problems) {
  const Slider& slider = document.input.slider;
  const auto table = shapes::shapes();
  const auto refuse = [&](const std::string& key, const std::string& others) {
    problems.add(fmt::format("{} does not belong to this shape of slider", key),
                 places(document, {key, "slider.shape"}),
                 fmt::format("remove it, or choose slider.shape = {}", others));
  };
  for (const auto& [name, value] : slider.parameters) {
    const ValueRecord* record = document.find("slider." + name);
    if (value != 0 && record && record->place && !laws::has_parameter(table, slider.shape, name))
      refuse(record->key, laws_with_parameter(table, name));
  }
  std::string with_heights;
  for (const shapes::ShapeRow& row : table)
    if (row.takes_heights)
      with_heights += fmt::format("{}\"{}\"", with_heights.empty() ? "" : " or ", row.name);
  if (!slider.profile.empty() && !shapes::shape_row(slider.shape).takes_heights)
    refuse("slider.profile", with_heights);
}

void check_softness(const CaseDocument& document, Problems& problems) {
  const Case& input = document.input;
  if (input.slider.rigid()) {
    for (const std::string key : {"slider.poissons_ratio", "slider.pad_thickness"})
      if (const ValueRecord* record = document.find(key); record && record->place)
        problems.add(fmt::format("{} is given, but the slider is rigid", key),
                     places(document, {key}), "give slider.youngs_modulus, or remove it");
  } else if (input.skin.sides == SideCondition::symmetry) {
    problems.add("a soft slider needs free sides: between planes of symmetry it would be repeated "
                 "without end",
                 places(document, {"slider.youngs_modulus", "skin.sides"}),
                 "set skin.sides = \"free\", or remove slider.youngs_modulus");
  }
}

/// Size of the whole body if the shape has one, else the size of the slider's own plan [m].
std::array<double, 2> whole_size(Slider slider) {
  const std::array<double, 2> own = slider.size;
  slider.size = {};
  return shapes::shape_row(slider.shape).has_whole_plan
             ? slider.underside()->whole_plan().value_or(own)
             : own;
}

} // namespace

void check_slider(const CaseDocument& document, Problems& problems) {
  check_foreign_keys(document, problems);
  check_softness(document, problems);
  check_pose(document, problems);
  const Slider& slider = document.input.slider;
  for (const shapes::Misfit& misfit : slider.underside()->misfits(slider.plan())) {
    std::vector<std::string> keys;
    for (const std::string& key : misfit.keys)
      keys.push_back("slider." + key);
    problems.add(misfit.message, places(document, keys), misfit.remedy);
  }
}

std::vector<std::string> notes_on_slider(const CaseDocument& document) {
  const ValueRecord* shape = document.find("slider.shape");
  const ValueRecord* size = document.find("slider.size");
  if (shape == nullptr || size == nullptr || shape->origin != ValueOrigin::set_edit ||
      size->origin != ValueOrigin::file) {
    return {};
  }
  const Slider& slider = document.input.slider;
  return {fmt::format(
      "slider.shape is changed to \"{}\", and keeps the plan of the shape in the file, {:.6g} mm x "
      "{:.6g} mm{}. Set slider.size too, such as slider.size=[\"{:.6g} mm\", \"{:.6g} mm\"].",
      slider.shape, slider.size[0] * 1e3, slider.size[1] * 1e3,
      shapes::shape_row(slider.shape).has_whole_plan ? ", to which it is cut" : "",
      whole_size(slider)[0] * 1e3, whole_size(slider)[1] * 1e3)};
}

} // namespace ionskin
