// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/checks/check_pose.hpp"

#include "ionskin/case/schema/schema_rows.hpp"
#include "ionskin/laws/friction/friction_law.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace ionskin {

namespace {

constexpr std::array<const char*, 3> angles{"roll", "pitch", "yaw"};

/// Positions of the angles in the case: those of the slider and of its first waypoints with angles,
/// or else of the key motion.file.
std::vector<Pointer> angle_places(const CaseDocument& document) {
  std::vector<Pointer> all;
  const auto append = [&](const std::string& key) {
    if (const ValueRecord* record = document.find(key); record != nullptr && record->place)
      for (const Pointer& pointer : document.point_at(key))
        all.push_back(pointer);
  };
  for (const std::string angle : angles)
    append("slider." + angle);
  constexpr std::size_t most = 3;
  for (std::size_t i = 0; i < document.input.motion.waypoints.size() && all.size() < most; ++i)
    for (const std::string angle : angles)
      append(fmt::format("motion.waypoints[{}].{}", i, angle));
  return all.empty() ? document.point_at("motion.file") : all;
}

void refuse_changes(const CaseDocument& document, Problems& problems) {
  const Case& input = document.input;
  if (!input.slider.changing.any())
    return;
  if (input.motion.drive.given())
    problems.add("a slider on a drive keeps its angles: the drive says nothing of their inertia",
                 angle_places(document),
                 "give all waypoints the same angles, or remove motion.drive");
  if (laws::friction_law(input.contact.law).adheres)
    problems.add(
        fmt::format("contact.law = \"{}\" takes a slider that keeps its angles", input.contact.law),
        angle_places(document),
        "give all waypoints the same angles, or choose another contact.law");
}

/// Refuses a roll or a yaw between symmetry planes. The slider would pull the skin along y, which
/// the planes (u_y = 0) prevent.
void refuse_between_planes(const CaseDocument& document, Problems& problems) {
  const Case& input = document.input;
  Slider upright = input.slider;
  upright.pose = {};
  upright.changing = {};
  if (input.skin.sides == SideCondition::symmetry && upright.symmetric()[1] &&
      !input.slider.symmetric()[1])
    problems.add("between planes of symmetry a slider can be pitched alone: rolled or turned it "
                 "pulls the skin across, and the planes would hold it",
                 angle_places(document), "set skin.sides = \"free\", or remove roll and yaw");
}

} // namespace

std::string remedy_of_tilt() {
  return fmt::format("a tilt is carried as a slope, up to {:.3g} deg; for more, give the tilted "
                     "underside as a height map (slider.shape = \"profile\")",
                     steepest_tilt * 180 / std::numbers::pi);
}

void check_pose(const CaseDocument& document, Problems& problems) {
  const Slider& slider = document.input.slider;
  if (slider.pose == shapes::Pose{} && !slider.changing.any())
    return;
  if (const double tilt = std::hypot(slider.pose.roll, slider.pose.pitch); tilt > steepest_tilt)
    problems.add(fmt::format("roll and pitch together tilt the slider by {:.4g} deg",
                             tilt * 180 / std::numbers::pi),
                 angle_places(document), remedy_of_tilt());
  refuse_changes(document, problems);
  refuse_between_planes(document, problems);
}

} // namespace ionskin
