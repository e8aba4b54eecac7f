// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace ionskin::live {

/// Throws UserError: the file is of no use.
[[noreturn]] inline void refuse(const std::string& what) {
  throw UserError(what + "\n  = make it again: ionskin live CASE.toml -o FILE");
}

/// Every entry: its name, its size in bytes as 8 bytes, its bytes.
class Writer {
public:
  explicit Writer(std::string_view begin) : bytes(begin) {}
  template <class T> void entry(const std::string& name, const T& value) {
    if constexpr (std::is_arithmetic_v<T>) {
      put(name, &value, sizeof value);
    } else if constexpr (std::is_same_v<T, std::vector<std::string>>) {
      std::string joined;
      for (const std::string& text : value) {
        joined += text + '\n';
      }
      put(name, joined.data(), joined.size());
    } else {
      put(name, value.data(), value.size() * sizeof value[0]);
    }
  }
  /// Symmetric matrices one after the other: of each only the rows up to the diagonal.
  void symmetric(const std::string& name, const std::vector<float>& matrices, std::size_t size) {
    std::vector<float> packed;
    for (std::size_t at = 0; at < matrices.size(); at += size) {
      const std::size_t end = std::min(matrices.size(), at + at / size % size + 1);
      packed.insert(packed.end(), matrices.begin() + static_cast<std::ptrdiff_t>(at),
                    matrices.begin() + static_cast<std::ptrdiff_t>(end));
    }
    entry(name, packed);
  }
  /// The number of elements of a list of structs, which follow.
  template <class T> void list(const std::string& name, const std::vector<T>& values) {
    entry(name, static_cast<std::uint64_t>(values.size()));
  }
  std::string bytes;

private:
  void put(const std::string& name, const void* data, std::uint64_t size) {
    bytes += name + '\n';
    bytes.append(reinterpret_cast<const char*>(&size), sizeof size);
    bytes.append(static_cast<const char*>(data), size);
  }
};

/// Takes the same entries in the same order. Throws UserError where they are others.
class Reader {
public:
  Reader(std::string_view bytes, std::string path) : rest_(bytes), path_(std::move(path)) {}

  template <class T> void entry(const std::string& name, T& value) {
    const std::string_view data = take(name);
    if constexpr (std::is_arithmetic_v<T>) {
      require(data.size() == sizeof value, name);
      std::memcpy(&value, data.data(), sizeof value);
    } else if constexpr (std::is_same_v<T, std::vector<std::string>>) {
      for (std::size_t from = 0; from < data.size();) {
        const std::size_t end = data.find('\n', from);
        require(end != std::string_view::npos, name);
        value.emplace_back(data.substr(from, end - from));
        from = end + 1;
      }
    } else if constexpr (std::is_same_v<T, std::string>) {
      value = data;
    } else {
      using Element = typename T::value_type;
      require(data.size() % sizeof(Element) == 0, name);
      if constexpr (requires { value.resize(1); }) {
        value.resize(data.size() / sizeof(Element));
      }
      require(data.size() == value.size() * sizeof(Element), name);
      if (!data.empty()) { // an empty list has no address to copy to
        std::memcpy(value.data(), data.data(), data.size());
      }
      for (const Element element : value) {
        require(std::isfinite(element), name);
      }
    }
  }
  void symmetric(const std::string& name, std::vector<float>& matrices, std::size_t size) {
    std::vector<float> packed;
    entry(name, packed);
    const std::size_t one = size * (size + 1) / 2;
    require(size > 0 && size < 30000 && packed.size() % one == 0, name);
    matrices.resize(packed.size() / one * size * size);
    const float* value = packed.data();
    for (std::size_t first = 0; first < matrices.size(); first += size * size) {
      for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
          matrices[first + i * size + j] = matrices[first + j * size + i] = *value++;
        }
      }
    }
  }
  template <class T> void list(const std::string& name, std::vector<T>& values) {
    std::uint64_t count = 0;
    entry(name, count);
    require(count <= 1000, name);
    values.resize(count);
  }
  void require(bool fits, const std::string& name) const {
    if (!fits) {
      refuse(path_ + ": entry " + name + " does not fit the others");
    }
  }
  bool at_end() const { return rest_.empty(); }

private:
  std::string_view take(const std::string& name) {
    std::uint64_t size = 0;
    require(rest_.substr(0, name.size() + 1) == name + '\n', name);
    rest_.remove_prefix(name.size() + 1);
    require(rest_.size() >= sizeof size, name);
    std::memcpy(&size, rest_.data(), sizeof size);
    rest_.remove_prefix(sizeof size);
    require(rest_.size() >= size, name);
    const std::string_view data = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return data;
  }

  std::string_view rest_;
  std::string path_;
};

} // namespace ionskin::live
