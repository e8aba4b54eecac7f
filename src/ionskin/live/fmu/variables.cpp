// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/fmu/variables.hpp"

#include "ionskin/live/skin.hpp"

#include <fmt/format.h>

#include <array>
#include <map>

namespace ionskin::live::fmu {
namespace {

/// Start value of the input `height`: well above the skin, so that nothing touches [m].
constexpr double above = 1e-3;

/// Unit of a signal, as the model description names it; empty for dimensionless.
std::string unit_of(const std::string& name) {
  if (name.starts_with("charge_")) {
    return "C";
  }
  if (name.starts_with("current_")) {
    return "A";
  }
  if (name.starts_with("slider_")) {
    return "m";
  }
  if (name == "contact_area") {
    return "m2";
  }
  if (name.starts_with("moment_")) {
    return "N.m";
  }
  return name.find("_force") != std::string::npos ? "N" : "";
}

std::string description_of(const std::string& name) {
  static const std::map<std::string, std::string> common{
      {"slider_x", "Place of the slider's centre along x, as used"},
      {"slider_y", "Place of the slider's centre along y, as used"},
      {"slider_z", "Height of the slider's underside above the undeformed top face, as used"},
      {"normal_force", "Normal force on the whole skin"},
      {"tangential_force", "Force on the skin along the first slide of the case"},
      {"tangential_force_x", "Force on the skin along x"},
      {"tangential_force_y", "Force on the skin along y"},
      {"moment_x", "Moment on the skin about x through the slider's centre"},
      {"moment_y", "Moment on the skin about y through the slider's centre"},
      {"moment_z", "Moment on the skin about z through the slider's centre"},
      {"contact_area", "Area of the contact"},
      {"stick_share", "Share of the contact area in which nothing slips"},
      {"mean_shear", "Mean shear of the core"},
      {"shear_first_moment", "First moment of the shear over the thickness"},
      {"charge_top", "Charge of the top electrode"},
      {"charge_bottom", "Charge of the bottom electrode"},
      {"current_top", "Current of the top electrode, mean over the step"},
      {"current_bottom", "Current of the bottom electrode, mean over the step"},
      {"current_difference", "Half the difference of both currents, mean over the step"},
      {"current_common", "Half the sum of both currents, mean over the step"},
      {"residual", "What the last sweep of the contact changed, over the largest force of a cell"}};
  if (const auto found = common.find(name); found != common.end()) {
    return found->second;
  }
  return name.starts_with("current_") ? "Current of a taxel, mean over the step"
                                      : "Charge of a taxel";
}

Variable angle_variable(const SkinData& data, std::size_t angle) {
  constexpr std::array names{"roll", "pitch", "yaw"};
  const std::string description =
      angle < 2 ? fmt::format("{} of the slider, as slider.{} of a case; trained for tilts up to "
                              "{:.6g} rad, roll and pitch together",
                              angle == 0 ? "Roll" : "Pitch", names[angle], data.steepest)
                : fmt::format("Yaw of the slider, as slider.yaw of a case; trained up to {:.6g} "
                              "rad/s",
                              data.fastest_turn);
  return {names[angle], Kind::real, Causality::input, "rad", description, 0};
}

} // namespace

std::vector<std::size_t> trained_angles(const SkinData& data) {
  std::vector<std::size_t> angles;
  if (data.steepest > 0) {
    angles = {0, 1};
  }
  if (data.fastest_turn > 0) {
    angles.push_back(2);
  }
  return angles;
}

std::vector<Variable> variables(const SkinData& data) {
  std::vector<Variable> list;
  for (std::size_t d = 0; d < 2; ++d) {
    list.push_back({d == 0 ? "x" : "y", Kind::real, Causality::input, "m",
                    fmt::format("Slider's centre; trained from {:.6g} m to {:.6g} m",
                                data.lowest_place[d], data.highest_place[d]),
                    (data.lowest_place[d] + data.highest_place[d]) / 2});
  }
  list.push_back({"height", Kind::real, Causality::input, "m",
                  fmt::format("Height of the slider's underside above the undeformed top face, "
                              "negative when it indents, unless force_control; trained down to "
                              "{:.6g} m",
                              -data.deepest_indentation),
                  above});
  list.push_back({"force", Kind::real, Causality::input, "N",
                  fmt::format("Normal force with force_control, 0 for none; trained up to {:.6g} N",
                              data.heaviest_force),
                  0});
  list.push_back({"friction", Kind::real, Causality::input, "",
                  fmt::format("Coefficient of friction; trained from {:.6g} to {:.6g}, and the "
                              "nearest of them is taken",
                              data.lowest_friction, data.highest_friction),
                  data.friction});
  list.push_back({"force_control", Kind::boolean, Causality::parameter, "",
                  "Whether force presses the slider, or height holds it", 0});
  list.push_back(
      {"flags", Kind::integer, Causality::output, "",
       "Sum of 1 outside the trained places, 2 loads, 4 speeds, 8 contact not converged, 16 an "
       "input is not finite, 32 a negative force, 64 a pose that was not trained",
       0});
  const Skin skin(data);
  for (const std::string& name : skin.names()) {
    list.push_back({name, Kind::real, Causality::output, unit_of(name), description_of(name), 0});
  }
  for (const std::size_t angle : trained_angles(data)) {
    list.push_back(angle_variable(data, angle));
  }
  return list;
}

} // namespace ionskin::live::fmu
