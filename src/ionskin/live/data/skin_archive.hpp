// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/digest.hpp"
#include "ionskin/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace ionskin::live {

/// Throws UserError: the file cannot be used and has to be trained again.
/// @param what message: the file, and what is wrong with it
[[noreturn]] inline void refuse(const std::string& what) {
  throw UserError(what + "\n  = make it again: ionskin live CASE.toml -o FILE");
}

/// Number of hexadecimal digits of the digest at the end of a file.
inline constexpr std::size_t digest_digits = 32;

/// Appends the digest of the content of a file.
inline std::string sealed(std::string content) {
  content += base::DigestBuilder().add_bytes(std::as_bytes(std::span(content))).finish().hex();
  return content;
}

/// Content of a file, without the digest at its end. Throws UserError where the digest does not
/// fit.
/// @param path of the file, for messages
inline std::string_view opened(std::string_view bytes, const std::string& path) {
  const std::string_view content =
      bytes.substr(0, bytes.size() - std::min(bytes.size(), digest_digits));
  if (base::DigestBuilder().add_bytes(std::as_bytes(std::span(content))).finish().hex() !=
      bytes.substr(content.size())) {
    refuse(path + ": is damaged or cut short: its digest does not fit");
  }
  return content;
}

/// Serialises values into a sequence of entries: name and line end, size in bytes (8 bytes), bytes.
class Writer {
public:
  /// Starts with the file's first line.
  explicit Writer(std::string_view begin) : bytes(begin) {}
  /// Appends a number, a string, a list of numbers, or a list of strings, which are joined by line
  /// ends.
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
  /// Appends symmetric matrices: of each, only the rows up to the diagonal.
  /// @param matrices [matrix][size][size]
  void symmetric(const std::string& name, const std::vector<float>& matrices, std::size_t size) {
    std::vector<float> packed;
    for (std::size_t at = 0; at < matrices.size(); at += size) {
      const std::size_t end = std::min(matrices.size(), at + at / size % size + 1);
      packed.insert(packed.end(), matrices.begin() + static_cast<std::ptrdiff_t>(at),
                    matrices.begin() + static_cast<std::ptrdiff_t>(end));
    }
    entry(name, packed);
  }
  /// Appends the number of elements of a list of structs, whose entries follow.
  template <class T> void list(const std::string& name, const std::vector<T>& values) {
    entry(name, static_cast<std::uint64_t>(values.size()));
  }
  /// Content so far.
  std::string bytes;

private:
  void put(const std::string& name, const void* data, std::uint64_t size) {
    bytes += name + '\n';
    bytes.append(reinterpret_cast<const char*>(&size), sizeof size);
    bytes.append(static_cast<const char*>(data), size);
  }
};

/// Reads the entries of a `Writer` in the order in which they were written. Every function throws
/// UserError where the next entry has another name or does not fit.
class Reader {
public:
  /// Starts at the first entry.
  /// @param bytes must outlive the reader
  /// @param path of the file, for messages
  Reader(std::string_view bytes, std::string path) : rest_(bytes), path_(std::move(path)) {}

  /// Reads an entry into a number, a string, a list of strings, or a list of finite numbers. An
  /// array with a fixed size must match.
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
  /// Reads symmetric matrices into full ones [matrix][size][size].
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
  /// Reads the number of elements of a list of structs, at most 1000, and resizes the list.
  template <class T> void list(const std::string& name, std::vector<T>& values) {
    std::uint64_t count = 0;
    entry(name, count);
    require(count <= 1000, name);
    values.resize(count);
  }
  /// Throws UserError, with the name of the entry, unless `fits`.
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
