// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/files/read_json.hpp"

#include "ionskin/base/files/read_text_file.hpp"

namespace ionskin::base {
namespace {

/// Parser that builds a JSON value as the library does, but stops at the first level that is too
/// deep.
class BoundedParser : public nlohmann::detail::json_sax_dom_parser<Json> {
public:
  using Base = nlohmann::detail::json_sax_dom_parser<Json>;
  using Base::Base;

  bool start_object(std::size_t size) { return enter() && Base::start_object(size); }
  bool end_object() { return leave() && Base::end_object(); }
  bool start_array(std::size_t size) { return enter() && Base::start_array(size); }
  bool end_array() { return leave() && Base::end_array(); }

private:
  bool enter() { return ++depth_ <= deepest_json; }
  bool leave() { return --depth_ >= 0; }

  int depth_ = 0;
};

} // namespace

std::optional<Json> parse_json(std::string_view text) {
  Json value;
  BoundedParser parser(value, false);
  if (!Json::sax_parse(text, &parser)) {
    return std::nullopt;
  }
  return value;
}

std::optional<Json> read_json(const std::filesystem::path& path, const char* what,
                              std::size_t most) {
  return parse_json(read_text_file(path.string(), what, most));
}

std::optional<Json> read_json(const FileDescriptor& file, const std::string& path, const char* what,
                              std::size_t most) {
  return parse_json(read_text_file(file, path, what, most));
}

} // namespace ionskin::base
