// SPDX-License-Identifier: Apache-2.0

// Any bytes, however they are cut, are a whole request within the limits, the beginning of one, or
// refused with an HttpError; without the cookie or the link none is admitted.

#include "studio/http/request_reader.hpp"
#include "studio/http/response.hpp"
#include "studio/server/access.hpp"
#include "studio/server/body_bytes.hpp"
#include "studio/server/http_error.hpp"
#include "studio/server/limits.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

using namespace ionskin::apps::studio;

void require(bool holds) {
  if (!holds) {
    std::abort();
  }
}

std::size_t total(const Request::Pairs& pairs) {
  std::size_t bytes = 0;
  for (const auto& [name, value] : pairs) {
    bytes += name.size() + value.size();
  }
  return bytes;
}

/// Outcome of a request that arrives in two parts: its status, or its words.
std::string outcome(std::string_view bytes, std::size_t cut, const RequestReader::Judge& judge) {
  RequestReader reader;
  try {
    reader.take(bytes.substr(0, cut), judge);
    const auto stage = reader.take(bytes.substr(cut), judge);
    const Request& request = reader.request();
    require(request.headers.size() <= limits::headers && request.body.size() <= limits::upload);
    require(total(request.headers) + total(request.parameters) + request.path.size() <=
            limits::head);
    std::string words = request.method + ' ' + request.path + ' ' + request.body;
    for (const auto& [name, value] : request.headers) {
      words += '\n' + name + ": " + value;
    }
    return words + '\n' + std::to_string(static_cast<int>(stage));
  } catch (const HttpError& error) {
    require(error.status() >= 400 && error.status() < 500);
    const Response response = error_response(error.status(), error.what());
    require(response.body.size() < 300 && head_of(response).size() < 1000);
    return std::to_string(error.status());
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  // The end of the input says where it is cut.
  const std::size_t cut = size == 0 ? 0 : data[size - 1] * 257u % (size + 1);
  require(outcome(bytes, cut, body_bytes) == outcome(bytes, size, body_bytes));
  static const Access access(8000);
  outcome(bytes, cut, [](const Request& head) -> std::size_t {
    access.require_own_origin(head);
    require(!access.has_cookie(head) && !access.opens(head));
    throw HttpError(401, "");
  });
  return 0;
}
