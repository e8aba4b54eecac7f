// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/files/sealed_file.hpp"

#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/system/own_build.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <limits>
#include <string>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace ionskin::base {
namespace {

constexpr std::string_view mark = "\nionskin-seal ";
constexpr std::size_t digits = 32;
constexpr std::size_t seal_size = mark.size() + digits + 1 + digits + 1;

/// Open regular file, with its size; not readable if the path is a link or not a regular file.
class InputFile {
public:
  InputFile(const std::filesystem::path& path, int flags)
      : descriptor_(::open(path.c_str(), flags | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC)) {
    reason_ = errno;
    struct stat status {};
    if (descriptor_ >= 0 && ::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode)) {
      size_ = static_cast<std::size_t>(status.st_size);
      regular_ = true;
    }
  }
  ~InputFile() {
    if (descriptor_ >= 0) {
      ::close(descriptor_);
    }
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  bool readable() const { return regular_; }
  bool missing() const { return descriptor_ < 0 && reason_ == ENOENT; }
  std::size_t size() const { return size_; }
  int descriptor() const { return descriptor_; }

  /// Reads bytes from a position of the file.
  /// @return false when the file ends before or cannot be read
  bool read(std::size_t place, std::span<char> bytes) const {
    while (!bytes.empty()) {
      const ssize_t count =
          ::pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(place));
      if (count == 0 || (count < 0 && errno != EINTR)) {
        return false;
      }
      place += count > 0 ? static_cast<std::size_t>(count) : 0;
      bytes = bytes.subspan(count > 0 ? static_cast<std::size_t>(count) : 0);
    }
    return true;
  }
  /// Digest of the first `size` bytes followed by a text. Nothing (`nullopt`) when they cannot be
  /// read.
  std::optional<Digest> digest(std::size_t size, std::string_view text) const {
    DigestBuilder builder;
    std::vector<char> block(std::min<std::size_t>(size, 1u << 20));
    for (std::size_t place = 0; place < size; place += block.size()) {
      const auto part = std::span(block).first(std::min(block.size(), size - place));
      if (!read(place, part)) {
        return std::nullopt;
      }
      builder.add_bytes(std::as_bytes(part));
    }
    return builder.add(text).finish();
  }

private:
  int descriptor_, reason_ = 0;
  std::size_t size_ = 0;
  bool regular_ = false;
};

/// Digest of this build for the seal. A build whose digest is unknown writes dashes, which match no
/// build, so its results are never reused.
std::string build_text() {
  const auto& build = own_build();
  return build ? build->hex() : std::string(digits, '-');
}

} // namespace

void seal(const std::filesystem::path& path) {
  const InputFile file(path, O_RDWR);
  const std::string build = build_text();
  const auto digest = file.readable() ? file.digest(file.size(), build) : std::nullopt;
  if (!digest) {
    throw UnwritableFile(path, "it cannot be read again");
  }
  const std::string text = fmt::format("{}{} {}\n", mark, build, digest->hex());
  const ssize_t count =
      ::pwrite(file.descriptor(), text.data(), text.size(), static_cast<off_t>(file.size()));
  if (count != static_cast<ssize_t>(text.size())) {
    throw UnwritableFile(path, std::strerror(count < 0 ? errno : ENOSPC));
  }
}

SealState check_seal(const std::filesystem::path& path) {
  const InputFile file(path, O_RDONLY);
  if (file.missing()) {
    return SealState::absent;
  }
  std::string text(seal_size, '\0');
  if (!file.readable() || file.size() < seal_size ||
      !file.read(file.size() - seal_size, std::span(text)) || !text.starts_with(mark)) {
    return SealState::damaged;
  }
  const std::string build = text.substr(mark.size(), digits);
  const auto digest = file.digest(file.size() - seal_size, build);
  if (!digest || text != fmt::format("{}{} {}\n", mark, build, digest->hex())) {
    return SealState::damaged;
  }
  return own_build() && build == own_build()->hex() ? SealState::whole : SealState::other_build;
}

std::optional<Digest> digest_if_readable(const std::filesystem::path& path) {
  const InputFile file(path, O_RDONLY);
  return file.readable() ? file.digest(file.size(), "") : std::nullopt;
}

} // namespace ionskin::base
