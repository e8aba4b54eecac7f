// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/server/http_error.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace ionskin::apps::studio {

using Json = nlohmann::ordered_json;

/// JSON text whatever bytes file names hold.
inline std::string dump(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The body of a request. Throws HttpError 400 when it is no JSON object.
inline Json parse_object(std::string_view text) {
  // Copies of a value recurse, so its nesting is bounded. Brackets within texts do not nest.
  int depth = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_text && c == '\\') {
      ++i;
    } else if (c == '"') {
      in_text = !in_text;
    } else if (!in_text) {
      depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
    }
    if (depth > 16) {
      throw HttpError(400, "the request is nested too deeply");
    }
  }
  Json value = Json::parse(text, nullptr, false);
  if (!value.is_object()) {
    throw HttpError(400, "the request holds no JSON object");
  }
  return value;
}

/// A text of a request, or the default when it is missing. Throws HttpError 400 for other types.
inline std::string text_of(const Json& object, const char* name,
                           const std::string& otherwise = "") {
  const auto entry = object.find(name);
  if (entry == object.end() || entry->is_null()) {
    return otherwise;
  }
  if (!entry->is_string()) {
    throw HttpError(400, std::string(name) + " is no text");
  }
  return entry->get<std::string>();
}

} // namespace ionskin::apps::studio
