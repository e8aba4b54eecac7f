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

/// Takes the same time wherever the texts differ.
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

void Access::require_own_origin(const httplib::Request& request) const {
  const std::string host = request.get_header_value("Host");
  const std::string by_number = fmt::format("127.0.0.1:{}", port_);
  const std::string by_name = fmt::format("localhost:{}", port_);
  if (request.get_header_value_count("Host") != 1 || (host != by_number && host != by_name)) {
    throw HttpError(403, "this host is not served here");
  }
  if (request.has_header("Origin") && request.get_header_value("Origin") != "http://" + host) {
    throw HttpError(403, "requests of other pages are refused");
  }
  const std::string site = request.get_header_value("Sec-Fetch-Site");
  if (site == "cross-site" || site == "same-site") {
    throw HttpError(403, "requests of other pages are refused");
  }
}

bool Access::has_cookie(const httplib::Request& request) const {
  const std::string cookies = "; " + request.get_header_value("Cookie");
  const std::string name = "; " + cookie_name_ + "=";
  const std::size_t begin = cookies.find(name);
  if (begin == std::string::npos) {
    return false;
  }
  const std::size_t value = begin + name.size();
  return equal(cookies.substr(value, cookies.find(';', value) - value), cookie_);
}

std::string Access::redeem(const std::string& path) {
  const std::lock_guard lock(mutex_);
  if (used_ || !equal(path, link_path_)) {
    return "";
  }
  used_ = true;
  return fmt::format("{}={}; HttpOnly; SameSite=Strict; Path=/", cookie_name_, cookie_);
}

} // namespace ionskin::apps::studio
