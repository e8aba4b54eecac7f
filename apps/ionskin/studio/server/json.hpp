// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/files/read_json.hpp"
#include "studio/server/http_error.hpp"

#include <string>
#include <string_view>

namespace ionskin::apps::studio {

using base::Json;

inline constexpr const char* json_type = "application/json; charset=utf-8";

/// JSON text whatever bytes file names hold.
inline std::string dump(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The body of a request. Throws HttpError 400 when it is not a JSON object, or nested too deeply.
inline Json parse_object(std::string_view text) {
  auto value = base::parse_json(text);
  if (!value || !value->is_object()) {
    throw HttpError(400, "the request holds no JSON object, or one that is nested too deeply");
  }
  return *std::move(value);
}

/// A text of a request, or the default when it is missing. Throws HttpError 400 for other types.
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
