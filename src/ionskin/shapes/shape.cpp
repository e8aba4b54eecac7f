// SPDX-License-Identifier: Apache-2.0
#include "ionskin/shapes/shape.hpp"

#include "ionskin/laws/named_row.hpp"
#include "ionskin/shapes/cylinder.hpp"
#include "ionskin/shapes/flat.hpp"
#include "ionskin/shapes/profile.hpp"
#include "ionskin/shapes/sphere.hpp"

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
  return {.name = name,
          .meaning = Kind::meaning,
          .takes_heights = Kind::takes_heights,
          .has_whole_plan = Kind::has_whole_plan,
          .parameters = laws::declared_parameters<Kind>(),
          .with = shape_with<Kind>};
}

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
  return laws::named_row(shapes(), name, "slider shape");
}

std::unique_ptr<const Shape> shape(std::string_view name, const laws::LawValues& values) {
  return shape_row(name).with(values);
}

} // namespace ionskin::shapes
