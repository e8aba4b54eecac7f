// SPDX-License-Identifier: Apache-2.0
#include "ionskin/shapes/shape.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/shapes/cylinder.hpp"
#include "ionskin/shapes/flat.hpp"
#include "ionskin/shapes/profile.hpp"
#include "ionskin/shapes/sphere.hpp"

#include <algorithm>

namespace ionskin::shapes {
namespace {

template <class Kind> std::unique_ptr<const Shape> shape_with(const laws::LawValues& values) {
  Kind result;
  for (const laws::OwnParameter<Kind>& own : Kind::parameters()) {
    if (const auto found = values.find(own.declared.name); found != values.end()) {
      result.*own.member = found->second;
    }
  }
  return std::make_unique<const Kind>(result);
}

template <class Kind> ShapeRow row(std::string_view name) {
  return {.name = name, .meaning = Kind::meaning, .takes_heights = requires {Kind::takes_heights;
}
, .has_whole_plan = requires {
  Kind::has_whole_plan;
}
, .parameters = laws::declared_parameters<Kind>(), .with = shape_with<Kind>
}; // namespace
} // namespace ionskin::shapes

} // namespace

std::span<const ShapeRow> shapes() {
  static const std::array rows{
      row<Flat>("flat"),
      row<Cylinder>("cylinder"),
      row<Sphere>("sphere"),
      row<Profile>("profile"),
  };
  return rows;
}

const ShapeRow& shape_row(std::string_view name) {
  const auto rows = shapes();
  const auto found = std::ranges::find(rows, name, &ShapeRow::name);
  if (found == rows.end()) {
    throw InternalError("no shape of slider is named " + std::string(name));
  }
  return *found;
}

std::unique_ptr<const Shape> shape(std::string_view name, const laws::LawValues& values) {
  return shape_row(name).with(values);
}

} // namespace ionskin::shapes
