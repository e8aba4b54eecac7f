// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/http/request.hpp"

#include <mutex>
#include <string>

namespace ionskin::apps::studio {

/// Access to the server: a browser that opened the one-time link, from its own page.
class Access {
public:
  explicit Access(int port);

  /// The path of the link: it opens the page once and gives the browser its cookie.
  const std::string& link_path() const { return link_path_; }

  /// Throws HttpError 403 when the request was sent for another host, or by another page: DNS
  /// rebinding, cross-site requests. Any page may lead to the link: one has to know it.
  void require_own_origin(const Request& request) const;
  bool has_cookie(const Request& request) const;
  /// True if the request gets the link, and the link was not used before.
  bool opens(const Request& request) const;
  /// The value of Set-Cookie when this gets the link and it was not used before; else empty.
  std::string redeem(const Request& request);

private:
  bool gets_link(const Request& request) const;

  int port_;
  std::string link_path_, cookie_name_, cookie_;
  mutable std::mutex mutex_;
  bool used_ = false;
};

} // namespace ionskin::apps::studio
