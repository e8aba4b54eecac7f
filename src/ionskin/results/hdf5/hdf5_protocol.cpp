// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/hdf5/hdf5_protocol.hpp"

#include "ionskin/base/error.hpp"

#include <cstring>

namespace ionskin::results {

std::string joined_texts(const std::vector<std::string>& texts) {
  std::string joined;
  for (const std::string& text : texts) {
    const std::uint64_t length = text.size();
    joined.append(reinterpret_cast<const char*>(&length), sizeof(length));
    joined += text;
  }
  return joined;
}

std::vector<std::string> separate_texts(std::string_view joined) {
  std::vector<std::string> texts;
  while (!joined.empty()) {
    std::uint64_t length = 0;
    if (joined.size() >= sizeof(length)) {
      std::memcpy(&length, joined.data(), sizeof(length));
    }
    if (joined.size() < sizeof(length) || joined.size() - sizeof(length) < length) {
      throw UserError("a list of texts is damaged");
    }
    joined.remove_prefix(sizeof(length));
    texts.emplace_back(joined.substr(0, length));
    joined.remove_prefix(length);
  }
  return texts;
}

} // namespace ionskin::results
