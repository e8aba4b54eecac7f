// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ionskin::apps::studio {

/// Answer to an HTTP request. It is always whole: ranges are not served, and nothing is compressed.
struct Response {
  /// Function that sends bytes to the client; returns false when the connection is lost.
  using Write = std::function<bool(std::string_view)>;

  int status = 200;
  std::string type; ///< content type; empty for none
  std::string body;
  /// Headers beside those that every answer has.
  std::vector<std::pair<std::string, std::string>> headers;
  /// Sends the content piece by piece in place of `body`, until it returns; empty for a fixed
  /// `body`.
  std::function<void(const Write&)> stream;
};

/// Answer with the JSON content {"error": message}.
/// @param status HTTP status code
Response error_response(int status, const std::string& message);

/// Text of an answer's head, including the empty line at its end. Its headers forbid pages of other
/// origins to show or read the answer, and browsers to store it.
std::string head_of(const Response& response);

} // namespace ionskin::apps::studio
