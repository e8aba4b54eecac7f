// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ionskin::apps::studio {

/// A request of HTTP/1.1 (RFC 9112).
struct Request {
  using Pairs = std::vector<std::pair<std::string, std::string>>;

  std::string method, path;
  Pairs headers;    ///< names in lower case
  Pairs parameters; ///< of the query, decoded
  std::string id;   ///< the number in the path of a job; the server fills it in
  std::string body;

  /// The value of the first header of this name in lower case; empty when there is none.
  std::string header(std::string_view name) const;
  /// Number of headers that have this name in lower case.
  std::size_t count(std::string_view name) const;
  /// The value of the first parameter of this name; empty when there is none.
  std::string parameter(std::string_view name) const;
};

/// A request without its body.
/// @param head the lines before the empty line, the last one without its end
/// Throws HttpError: 400 when it is not strictly of RFC 9112, 431 when it has too many headers.
Request parse_head(std::string_view head);

} // namespace ionskin::apps::studio
