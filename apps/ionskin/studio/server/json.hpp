// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/files/read_json.hpp"
#include "studio/server/http_error.hpp"

#include <string>
#include <string_view>

namespace ionskin::apps::studio {

using base::Json;

/// Content type of JSON answers.
inline constexpr const char* json_type = "application/json; charset=utf-8";

/// Text of a JSON value. Bytes that are not UTF-8, as names of files may hold, are replaced.
inline std::string dump(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Parses the body of a request, a JSON object. Throws HttpError 400 when it is anything else, or
/// nested too deeply.
inline Json parse_object(std::string_view text) {
  auto value = base::parse_json(text);
  if (!value || !value->is_object()) {
    throw HttpError(400, "the request holds no JSON object, or one that is nested too deeply");
  }
  return *std::move(value);
}

/// Text in a member of a request, or `otherwise` when the member is missing or null. Throws
/// HttpError 400 when it has another type.
inline std::string text_of(const Json& object, const char* name,
                           const std::string& otherwise = "") {
  const auto entry = object.find(name);
  if (entry == object.end() || entry->is_null()) {
    return otherwise;
  }
  if (!entry->is_string()) {
    throw HttpError(400, std::string(name) + " is not a text");
  }
  return entry->get<std::string>();
}

} // namespace ionskin::apps::studio
