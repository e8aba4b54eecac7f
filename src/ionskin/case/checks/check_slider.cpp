// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/checks/check_slider.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ionskin {

namespace {

std::vector<Pointer> places(const CaseDocument& document, const std::vector<std::string>& keys) {
  std::vector<Pointer> all;
  for (const std::string& key : keys)
    for (const Pointer& pointer : document.point_at(key))
      all.push_back(pointer);
  return all;
}

void check_foreign_keys(const CaseDocument& document, Problems& problems) {
  const Slider& slider = document.input.slider;
  const auto refuse = [&](const std::string& key, const std::string& shapes) {
    problems.add(fmt::format("{} does not belong to this shape of slider", key),
                 places(document, {key, "slider.shape"}),
                 fmt::format("remove it, or choose slider.shape = {}", shapes));
  };
  const bool round = slider.shape == SliderShape::cylinder || slider.shape == SliderShape::sphere;
  if (slider.edge_radius > 0 && slider.shape != SliderShape::flat)
    refuse("slider.edge_radius", "\"flat\"");
  if (slider.radius > 0 && !round)
    refuse("slider.radius", "\"cylinder\" or \"sphere\"");
  if (!slider.profile.empty() && slider.shape != SliderShape::profile)
    refuse("slider.profile", "\"profile\"");
}

void check_flat(const CaseDocument& document, Problems& problems) {
  const Slider& slider = document.input.slider;
  const double most = std::min(slider.size[0], slider.size[1]) / 2;
  if (slider.edge_radius > most)
    problems.add(fmt::format("slider.edge_radius = {:.6g} mm is more than half the slider's "
                             "smaller side",
                             slider.edge_radius * 1e3),
                 places(document, {"slider.edge_radius", "slider.size"}),
                 fmt::format("it must be at most {:.6g} mm", most * 1e3));
}

void check_round(const CaseDocument& document, Problems& problems) {
  const Slider& slider = document.input.slider;
  const std::size_t directions = slider.shape == SliderShape::sphere ? 2 : 1;
  for (std::size_t d = 0; d < directions; ++d)
    if (slider.size[d] > 2 * slider.radius * (1 + 1e-12))
      problems.add(fmt::format("the slider is {:.6g} mm long along {}, more than the diameter of "
                               "{:.6g} mm",
                               slider.size[d] * 1e3, d == 0 ? "x" : "y", 2e3 * slider.radius),
                   places(document, {"slider.size", "slider.radius"}),
                   fmt::format("it must be at most {:.6g} mm", 2e3 * slider.radius));
}

void check_profile(const CaseDocument& document, Problems& problems) {
  const Slider& slider = document.input.slider;
  const HeightMap& map = slider.profile_heights;
  const auto covers = [](const std::vector<double>& lines, double size) {
    const double least = size / 2 * (1 - 1e-9);
    return lines.front() <= -least && lines.back() >= least;
  };
  if (!covers(map.x, slider.size[0]) || !covers(map.y, slider.size[1]))
    problems.add(
        fmt::format("the height map reaches from {:.6g} mm to {:.6g} mm along x and from {:.6g} mm "
                    "to {:.6g} mm along y, less than slider.size",
                    map.x.front() * 1e3, map.x.back() * 1e3, map.y.front() * 1e3,
                    map.y.back() * 1e3),
        places(document, {"slider.profile", "slider.size"}),
        "coordinates of the height map count from the slider's centre");
}

} // namespace

void check_slider(const CaseDocument& document, Problems& problems) {
  check_foreign_keys(document, problems);
  switch (document.input.slider.shape) {
  case SliderShape::flat:
    return check_flat(document, problems);
  case SliderShape::cylinder:
  case SliderShape::sphere:
    return check_round(document, problems);
  case SliderShape::profile:
    return check_profile(document, problems);
  }
}

} // namespace ionskin
