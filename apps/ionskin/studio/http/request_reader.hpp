// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/http/request.hpp"

#include <functional>

namespace ionskin::apps::studio {

/// Assembles one request from its bytes as they arrive. The body is stored only after the head was
/// admitted.
class RequestReader {
public:
  /// Part of the request that is awaited; `whole` when all of it has arrived.
  enum class Stage { head, body, whole };
  /// Decides by its head whether a request is admitted, and returns the size of its body [bytes].
  /// Throws HttpError to refuse it.
  using Judge = std::function<std::size_t(const Request&)>;

  /// Takes the next bytes and returns the stage; bytes beyond the request are ignored.
  /// Throws HttpError: that of `judge`, that of `parse_head`, or 431 when the head is too long.
  Stage take(std::string_view bytes, const Judge& judge);
  Stage stage() const { return stage_; }
  /// The request: whole at the stage `whole`; at the stage `body` only its head.
  Request& request() { return request_; }
  /// Size of the body [bytes]; 0 before the head was admitted.
  std::size_t body_length() const { return body_length_; }

private:
  Stage stage_ = Stage::head;
  std::string head_;
  Request request_;
  std::size_t body_length_ = 0;
};

} // namespace ionskin::apps::studio
