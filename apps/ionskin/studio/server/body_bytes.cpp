// SPDX-License-Identifier: Apache-2.0
#include "studio/server/body_bytes.hpp"

#include "studio/server/http_error.hpp"
#include "studio/server/limits.hpp"

#include <fmt/format.h>

#include <charconv>

namespace ionskin::apps::studio {

std::size_t body_bytes(const Request& head) {
  if (head.method == "GET" || head.method == "HEAD") {
    if (head.count("content-length") > 0 || head.count("transfer-encoding") > 0) {
      throw HttpError(400, "this request has no body");
    }
    return 0;
  }
  if (head.count("transfer-encoding") > 0 || head.count("content-encoding") > 0 ||
      head.count("content-length") != 1) {
    throw HttpError(411,
                    "the length of the body must be stated beforehand, and it must not be packed");
  }
  const std::string length = head.header("content-length");
  const bool upload = head.path == "/api/upload";
  const std::size_t limit = upload ? limits::upload : limits::body;
  std::size_t bytes = 0;
  const auto [end, problem] = std::from_chars(length.data(), length.data() + length.size(), bytes);
  if (problem != std::errc() || end != length.data() + length.size() || bytes > limit) {
    throw HttpError(413, fmt::format("a body has {} MiB at most", limit >> 20));
  }
  if (head.header("content-type") != (upload ? "text/csv" : "application/json")) {
    throw HttpError(415, "the body is JSON (application/json), or a CSV file (text/csv)");
  }
  return bytes;
}

} // namespace ionskin::apps::studio
