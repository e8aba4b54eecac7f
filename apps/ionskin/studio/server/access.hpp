// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/http/request.hpp"

#include <mutex>
#include <string>

namespace ionskin::apps::studio {

/// Access control of the server: only a browser that opened the Studio's one-time link, and only
/// requests from its own page, are answered.
class Access {
public:
  /// Makes a random link and a random cookie.
  /// @param port TCP port of the server
  explicit Access(int port);

  /// Path of the one-time link. Opening it shows the page and gives the browser its cookie; it
  /// works once.
  const std::string& link_path() const { return link_path_; }

  /// Requires that a request was sent to this server by its own page. Throws HttpError 403 when it
  /// names another host (DNS rebinding) or comes from another page (cross-site request). A request
  /// of the unused link may come from any page, since the link is secret.
  void require_own_origin(const Request& request) const;
  /// True if the request has the cookie that the link gave.
  bool has_cookie(const Request& request) const;
  /// True if the request opens the link, and the link was not used before.
  bool opens(const Request& request) const;
  /// Uses the link: returns the value of the header Set-Cookie if the request opens the link for
  /// the first time; else an empty text.
  std::string redeem(const Request& request);

private:
  bool gets_link(const Request& request) const;

  int port_;
  std::string link_path_, cookie_name_, cookie_;
  mutable std::mutex mutex_;
  bool used_ = false;
};

} // namespace ionskin::apps::studio
