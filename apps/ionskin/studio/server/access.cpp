// SPDX-License-Identifier: Apache-2.0
#include "studio/server/access.hpp"

#include "ionskin/base/error.hpp"
#include "studio/server/http_error.hpp"

#include <fmt/format.h>

#include <array>
#include <sys/random.h>

namespace ionskin::apps::studio {
namespace {

std::string random_token() {
  std::array<unsigned char, 32> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw InternalError("the system gives no random numbers");
  }
  std::string text;
  for (const unsigned char byte : bytes) {
    text += fmt::format("{:02x}", byte);
  }
  return text;
}

/// True if two texts are equal. The comparison takes the same time wherever they differ, so that
/// timing tells nothing of a secret.
bool equal(const std::string& one, const std::string& two) {
  if (one.size() != two.size()) {
    return false;
  }
  unsigned char difference = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    difference |= static_cast<unsigned char>(one[i] ^ two[i]);
  }
  return difference == 0;
}

} // namespace

Access::Access(int port)
    : port_(port), link_path_("/open/" + random_token()),
      // Cookies do not tell ports apart; their names do.
      cookie_name_(fmt::format("ionskin_studio_{}", port)), cookie_(random_token()) {}

void Access::require_own_origin(const Request& request) const {
  const std::string host = request.header("host");
  const std::string by_number = fmt::format("127.0.0.1:{}", port_);
  const std::string by_name = fmt::format("localhost:{}", port_);
  if (request.count("host") != 1 || (host != by_number && host != by_name)) {
    throw HttpError(403, "this host is not served here");
  }
  if (request.count("origin") > 0 && request.header("origin") != "http://" + host) {
    throw HttpError(403, "requests of other pages are refused");
  }
  const std::string site = request.header("sec-fetch-site");
  if ((site == "cross-site" || site == "same-site") && !opens(request)) {
    throw HttpError(403, "requests of other pages are refused");
  }
}

bool Access::has_cookie(const Request& request) const {
  const std::string cookies = "; " + request.header("cookie");
  const std::string name = "; " + cookie_name_ + "=";
  const std::size_t begin = cookies.find(name);
  if (begin == std::string::npos) {
    return false;
  }
  const std::size_t value = begin + name.size();
  return equal(cookies.substr(value, cookies.find(';', value) - value), cookie_);
}

bool Access::gets_link(const Request& request) const {
  return request.method == "GET" && equal(request.path, link_path_);
}

bool Access::opens(const Request& request) const {
  const std::lock_guard lock(mutex_);
  return !used_ && gets_link(request);
}

std::string Access::redeem(const Request& request) {
  const std::lock_guard lock(mutex_);
  if (used_ || !gets_link(request)) {
    return "";
  }
  used_ = true;
  return fmt::format("{}={}; HttpOnly; SameSite=Strict; Path=/", cookie_name_, cookie_);
}

} // namespace ionskin::apps::studio
