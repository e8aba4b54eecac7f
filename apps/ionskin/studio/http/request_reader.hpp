// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/http/request.hpp"

#include <functional>

namespace ionskin::apps::studio {

/// Puts a request together from its bytes as they arrive. Nothing of a body is kept before the head
/// was judged.
class RequestReader {
public:
  enum class Stage { head, body, whole };
  /// Bytes that the body of a request with this head has. Throws HttpError when it is refused.
  using Judge = std::function<std::size_t(const Request&)>;

  /// Takes the next bytes; those beyond the request are passed over.
  /// Throws HttpError: of the judge, of `parse_head`, or 431 when the head is too long.
  Stage take(std::string_view bytes, const Judge& judge);
  Stage stage() const { return stage_; }
  /// Complete once the stage is `whole`; from the stage `body` on, its head is there.
  Request& request() { return request_; }
  /// Bytes that the body will have; 0 before the head was judged.
  std::size_t body_length() const { return body_length_; }

private:
  Stage stage_ = Stage::head;
  std::string head_;
  Request request_;
  std::size_t body_length_ = 0;
};

} // namespace ionskin::apps::studio
