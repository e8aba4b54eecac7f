// SPDX-License-Identifier: Apache-2.0
#include "studio/http/response.hpp"

#include "studio/server/json.hpp"

#include <fmt/format.h>

namespace ionskin::apps::studio {
namespace {

// uPlot places its parts through the style attributes of elements, which scripts may set anyhow.
constexpr std::string_view safety_headers =
    "Content-Security-Policy: default-src 'self'; img-src 'self' data: blob:; style-src 'self'; "
    "object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'\r\n"
    "X-Content-Type-Options: nosniff\r\n"
    "X-Frame-Options: DENY\r\n"
    "Referrer-Policy: no-referrer\r\n"
    "Cross-Origin-Opener-Policy: same-origin\r\n"
    "Cross-Origin-Resource-Policy: same-origin\r\n"
    "Cache-Control: no-store\r\n"
    "Accept-Ranges: none\r\n"
    "Connection: close\r\n";

} // namespace

Response error_response(int status, const std::string& message) {
  Response response;
  response.status = status;
  response.type = json_type;
  response.body = dump({{"error", message}});
  return response;
}

std::string head_of(const Response& response) {
  std::string head = fmt::format("HTTP/1.1 {} \r\n{}", response.status, safety_headers);
  if (!response.type.empty()) {
    head += fmt::format("Content-Type: {}\r\n", response.type);
  }
  if (!response.stream) {
    head += fmt::format("Content-Length: {}\r\n", response.body.size());
  }
  for (const auto& [name, value] : response.headers) {
    head += fmt::format("{}: {}\r\n", name, value);
  }
  return head + "\r\n";
}

} // namespace ionskin::apps::studio
