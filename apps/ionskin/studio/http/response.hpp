// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ionskin::apps::studio {

/// Answer to a request, always whole: ranges are not served, and nothing is compressed.
struct Response {
  /// Sends some bytes. False when the connection is lost.
  using Write = std::function<bool(std::string_view)>;

  int status = 200;
  std::string type; ///< of the content; empty for none
  std::string body;
  std::vector<std::pair<std::string, std::string>> headers; ///< more than every answer has
  /// When set, it sends the content bit by bit instead of `body`, until it returns.
  std::function<void(const Write&)> stream;
};

/// The answer {"error": message}.
Response error_response(int status, const std::string& message);

/// The head of an answer, up to the empty line and with it. Every answer forbids that pages of
/// others show or read it, and that it is kept.
std::string head_of(const Response& response);

} // namespace ionskin::apps::studio
