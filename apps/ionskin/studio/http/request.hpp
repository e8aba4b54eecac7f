// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ionskin::apps::studio {

/// HTTP/1.1 request (RFC 9112).
struct Request {
  using Pairs = std::vector<std::pair<std::string, std::string>>;

  std::string method, path;
  Pairs headers;    ///< names in lower case
  Pairs parameters; ///< parameters of the query, decoded, in their order
  /// Number of the job in a path /api/jobs/NUMBER, which the server fills in; else empty.
  std::string id;
  std::string body;

  /// Value of the first header of a name, which is given in lower case; empty when there is none.
  std::string header(std::string_view name) const;
  /// Number of headers of a name, which is given in lower case.
  std::size_t count(std::string_view name) const;
  /// Value of the first parameter of a name; empty when there is none.
  std::string parameter(std::string_view name) const;
};

/// Parses the head of a request; the body stays empty.
/// @param head lines before the empty line, without the end of the last line
/// Throws HttpError: 400 when the head does not follow RFC 9112 strictly, 431 when it has too many
/// headers.
Request parse_head(std::string_view head);

} // namespace ionskin::apps::studio
