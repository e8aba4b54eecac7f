// SPDX-License-Identifier: Apache-2.0
#include "studio/data/result_shape.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/text.hpp"

#include <string>

namespace ionskin::apps::studio {
namespace {

using Test = bool (*)(const Json&);

bool is_text(const Json& value) {
  return value.is_string();
}

/// True if a value is a number, or null, which stands for a number that is not finite.
bool is_figure(const Json& value) {
  return value.is_number() || value.is_null();
}

bool is_number_or_missing(const Json& object, const char* name) {
  return !object.contains(name) || is_figure(object.at(name));
}

/// True if a value is a quantity: an object with a value, a unit, and the ends of its interval if
/// it has one.
bool is_quantity(const Json& value) {
  return value.is_object() && value.contains("value") && is_figure(value.at("value")) &&
         value.contains("unit") && is_text(value.at("unit")) &&
         is_number_or_missing(value, "lower_95") && is_number_or_missing(value, "upper_95");
}

[[noreturn]] void refuse_entry(const std::string& entry) {
  throw UserError(base::shown(entry) + " is damaged: its value has another type than ionskin "
                                       "writes");
}

void require(const Json& object, const char* name, Test test) {
  if (object.contains(name) && !test(object.at(name))) {
    refuse_entry(name);
  }
}

/// Requires that every entry of an inner object or list meets a condition.
void require_all(const Json& object, const char* name, Json::value_t container, Test test) {
  const auto inner = object.find(name);
  if (inner == object.end()) {
    return;
  }
  if (inner->type() != container) {
    refuse_entry(name);
  }
  for (const auto& [key, value] : inner->items()) {
    if (!test(value)) {
      refuse_entry(std::string(name) + "." + key);
    }
  }
}

} // namespace

void require_manifest(const Json& manifest) {
  for (const char* name : {"state", "started", "command"}) {
    require(manifest, name, is_text);
  }
}

void require_summary(const Json& summary) {
  require_all(summary, "warnings", Json::value_t::array, is_text);
  require_all(summary, "metrics", Json::value_t::object, is_quantity);
  require_all(summary, "parameters", Json::value_t::object, is_quantity);
  for (const char* name : {"error_estimate", "timing"}) {
    require_all(summary, name, Json::value_t::object, is_figure);
  }
  require(summary, "column", is_text);
}

} // namespace ionskin::apps::studio
