// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/checks/check_shared_positions.hpp"

#include "ionskin/case/slider_motion.hpp"

#include <fmt/format.h>

#include <array>
#include <string>

namespace ionskin {

namespace {

constexpr const char* from_key = "numerics.shared_positions.from";
constexpr const char* to_key = "numerics.shared_positions.to";
constexpr const char* footprint_key = "numerics.shared_positions.footprint";

bool has(const CaseDocument& document, const char* key) {
  const ValueRecord* record = document.find(key);
  return record != nullptr && record->place.has_value();
}

std::string in_millimetres(const std::array<double, 2>& place) {
  return fmt::format("[\"{:.9g} mm\", \"{:.9g} mm\"]", place[0] * 1e3, place[1] * 1e3);
}

/// @return whether both corners are there
bool check_complete(const CaseDocument& document, Problems& problems) {
  const bool from = has(document, from_key), to = has(document, to_key);
  if (from == to && (from || !has(document, footprint_key))) {
    return from;
  }
  const char* missing = from ? to_key : from_key;
  problems.add(fmt::format("{} is missing", missing),
               document.point_at(from ? from_key
                                 : to ? to_key
                                      : footprint_key),
               "a shared rectangle has two corners, from and to");
  return false;
}

void check_rectangle(const CaseDocument& document, Problems& problems) {
  const Case& input = document.input;
  const SharedPositions& shared = input.numerics.shared;
  const std::array<double, 2> skin{input.skin.length, input.skin.width};
  const MotionBox box = motion_box(input.motion, input.slider);
  for (std::size_t d = 0; d < 2; ++d) {
    const char* axis = d == 0 ? "x" : "y";
    if (shared.from[d] > shared.to[d] || shared.to[d] > skin[d]) {
      problems.add(fmt::format("numerics.shared_positions goes from {:.6g} mm to {:.6g} mm along "
                               "{}, on a skin of {:.6g} mm",
                               shared.from[d] * 1e3, shared.to[d] * 1e3, axis, skin[d] * 1e3),
                   document.point_at(to_key), "its corners ascend and lie on the skin");
      return;
    }
  }
  for (std::size_t d = 0; d < 2; ++d) {
    const double tolerance = 1e-9 * skin[d];
    if (box.low[d] < shared.from[d] - tolerance || box.high[d] > shared.to[d] + tolerance) {
      problems.add(fmt::format("the slider leaves numerics.shared_positions: along {} it goes from "
                               "{:.6g} mm to {:.6g} mm, the rectangle from {:.6g} mm to {:.6g} mm",
                               d == 0 ? "x" : "y", box.low[d] * 1e3, box.high[d] * 1e3,
                               shared.from[d] * 1e3, shared.to[d] * 1e3),
                   document.point_at(box.low[d] < shared.from[d] - tolerance ? from_key : to_key),
                   fmt::format("it must hold from {} to {}", in_millimetres(box.low),
                               in_millimetres(box.high)));
      return;
    }
  }
}

} // namespace

void check_shared_positions(const CaseDocument& document, Problems& problems) {
  if (!check_complete(document, problems)) {
    return;
  }
  check_rectangle(document, problems);
  if (has(document, footprint_key) && document.input.slider.sharp()) {
    problems.add("numerics.shared_positions.footprint is given, but the slider has sharp edges: "
                 "it touches no more than its size",
                 document.point_at(footprint_key), "remove it");
  }
}

} // namespace ionskin
