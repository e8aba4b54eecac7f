// SPDX-License-Identifier: Apache-2.0
#include "studio/http/request_reader.hpp"

#include "studio/server/http_error.hpp"
#include "studio/server/limits.hpp"

#include <algorithm>

namespace ionskin::apps::studio {

RequestReader::Stage RequestReader::take(std::string_view bytes, const Judge& judge) {
  if (stage_ == Stage::head) {
    constexpr std::string_view end_mark = "\r\n\r\n";
    // The mark may have begun with the last bytes that came before.
    const std::size_t from = head_.size() - std::min(head_.size(), end_mark.size() - 1);
    const std::size_t before = head_.size();
    head_ += bytes.substr(0, limits::head + end_mark.size() - before);
    const std::size_t end = head_.find(end_mark, from);
    if (end == head_.npos || end > limits::head) {
      if (head_.size() >= limits::head + end_mark.size()) {
        throw HttpError(431, "the head of the request is too long");
      }
      return stage_;
    }
    request_ = parse_head(std::string_view(head_).substr(0, end));
    body_length_ = judge(request_);
    stage_ = Stage::body;
    bytes.remove_prefix(end + end_mark.size() - before);
    head_ = {};
  }
  request_.body += bytes.substr(0, body_length_ - request_.body.size());
  if (request_.body.size() == body_length_) {
    stage_ = Stage::whole;
  }
  return stage_;
}

} // namespace ionskin::apps::studio
