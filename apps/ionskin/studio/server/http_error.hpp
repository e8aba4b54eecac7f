// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace ionskin::apps::studio {

/// Exception that ends a request with an HTTP error: status code, and a message for the user.
class HttpError : public std::runtime_error {
public:
  HttpError(int status, const std::string& message)
      : std::runtime_error(message), status_(status) {}
  int status() const { return status_; }

private:
  int status_;
};

} // namespace ionskin::apps::studio
