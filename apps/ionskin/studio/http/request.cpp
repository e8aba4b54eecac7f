// SPDX-License-Identifier: Apache-2.0
#include "studio/http/request.hpp"

#include "ionskin/base/text.hpp"
#include "studio/server/http_error.hpp"
#include "studio/server/limits.hpp"

#include <algorithm>
#include <charconv>

namespace ionskin::apps::studio {
namespace {

constexpr std::string_view line_end = "\r\n";

/// Removes the text before a separator, and the separator, from the front and returns it; the whole
/// text where there is no separator.
std::string_view take_until(std::string_view& text, std::string_view separator) {
  const std::size_t end = text.find(separator);
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(end == text.npos ? text.size() : end + separator.size());
  return taken;
}

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

/// True if a text consists of letters that names of methods and headers may have.
bool is_token(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return is_letter_or_digit(c) ||
           std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string::npos;
  });
}

bool is_visible(char c) {
  return c > ' ' && c <= '~';
}

/// Decodes a part of a query: "+" is a blank, "%41" is "A"; other characters stay.
std::string decoded(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned char byte = 0;
    const char* const digits = text.data() + i + 1;
    if (text[i] == '%' && i + 2 < text.size() &&
        std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
      plain += static_cast<char>(byte);
      i += 2;
    } else {
      plain += text[i] == '+' ? ' ' : text[i];
    }
  }
  return plain;
}

Request::Pairs parameters_of(std::string_view query) {
  Request::Pairs parameters;
  while (!query.empty()) {
    std::string_view value = take_until(query, "&");
    const std::string_view name = take_until(value, "=");
    parameters.emplace_back(decoded(name), decoded(value));
  }
  return parameters;
}

std::pair<std::string, std::string> header_of(std::string_view line) {
  const std::size_t colon = line.find(':');
  std::string value = base::trimmed(line.substr(colon == line.npos ? line.size() : colon + 1));
  const bool plain = std::ranges::none_of(
      value, [](char c) { return (c >= 0 && c < ' ' && c != '\t') || c == '\x7f'; });
  if (colon == line.npos || !is_token(line.substr(0, colon)) || !plain) {
    throw HttpError(400, "a header is malformed");
  }
  std::string name(line.substr(0, colon));
  std::ranges::transform(name, name.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return {std::move(name), std::move(value)};
}

std::string first(const Request::Pairs& pairs, std::string_view name) {
  const auto found = std::ranges::find(pairs, name, &Request::Pairs::value_type::first);
  return found == pairs.end() ? "" : found->second;
}

} // namespace

std::string Request::header(std::string_view name) const {
  return first(headers, name);
}

std::size_t Request::count(std::string_view name) const {
  return static_cast<std::size_t>(
      std::ranges::count(headers, name, &Request::Pairs::value_type::first));
}

std::string Request::parameter(std::string_view name) const {
  return first(parameters, name);
}

Request parse_head(std::string_view head) {
  std::string_view version = take_until(head, line_end);
  const std::string_view method = take_until(version, " ");
  std::string_view query = take_until(version, " ");
  if (!is_token(method) || !query.starts_with('/') || !std::ranges::all_of(query, is_visible) ||
      (version != "HTTP/1.1" && version != "HTTP/1.0")) {
    throw HttpError(400, "the first line is not that of a request");
  }
  Request request;
  request.method = method;
  request.path = take_until(query, "?");
  request.parameters = parameters_of(query);
  while (!head.empty()) {
    if (request.headers.size() == limits::headers) {
      throw HttpError(431, "the request has too many headers");
    }
    request.headers.push_back(header_of(take_until(head, line_end)));
  }
  return request;
}

} // namespace ionskin::apps::studio
