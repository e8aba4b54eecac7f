// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/cache_file.hpp"

#include <fmt/core.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ionskin::base {
namespace {

/// First bytes of every cache file, in the byte order of the machine that wrote it.
struct Header {
  std::array<char, 8> mark{'i', 'o', 'n', 's', 'k', 'i', 'n', '\n'};
  std::uint32_t version = cache_file_version;
  std::uint32_t byte_order = 0x01020304;
  Digest key;
  std::uint64_t bytes = 0; ///< of the content
  Digest checksum;         ///< of the key and the content
};
static_assert(sizeof(Header) == 56);

Digest checksum(const Digest& key, const std::vector<std::span<const std::byte>>& parts) {
  DigestBuilder builder;
  builder.add(key.high).add(key.low);
  for (const auto& part : parts) {
    builder.add_bytes(part);
  }
  return builder.finish();
}

class OpenFile {
public:
  OpenFile(const std::filesystem::path& path, int flags)
      : descriptor_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~OpenFile() {
    if (is_open()) {
      ::close(descriptor_);
    }
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  bool is_open() const { return descriptor_ >= 0; }
  std::uint64_t size() const {
    struct stat status {};
    return ::fstat(descriptor_, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
  }
  bool read(std::span<std::byte> bytes) const {
    while (!bytes.empty()) {
      const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
      if (count == 0 || (count < 0 && errno != EINTR)) {
        return false;
      }
      bytes = bytes.subspan(count > 0 ? static_cast<std::size_t>(count) : 0);
    }
    return true;
  }
  bool write(std::span<const std::byte> bytes) const {
    while (!bytes.empty()) {
      const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
      if (count < 0 && errno != EINTR) {
        return false;
      }
      bytes = bytes.subspan(count > 0 ? static_cast<std::size_t>(count) : 0);
    }
    return true;
  }
  bool flush() const { return ::fsync(descriptor_) == 0; }

private:
  int descriptor_;
};

/// Turns the signal of a limit on file sizes into an error of `write` while it lives.
class FileLimitGuard {
public:
  FileLimitGuard() {
    sigemptyset(&limit_);
    sigaddset(&limit_, SIGXFSZ);
    pthread_sigmask(SIG_BLOCK, &limit_, &before_);
  }
  ~FileLimitGuard() {
    const timespec now{};
    sigtimedwait(&limit_, nullptr, &now); // takes a pending signal away
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  FileLimitGuard(const FileLimitGuard&) = delete;
  FileLimitGuard& operator=(const FileLimitGuard&) = delete;

private:
  sigset_t limit_{}, before_{};
};

bool write_all(const std::filesystem::path& path, const Header& header,
               const std::vector<std::span<const std::byte>>& parts) {
  const FileLimitGuard guard;
  const OpenFile file(path, O_WRONLY | O_CREAT | O_EXCL);
  if (!file.is_open() || !file.write(std::as_bytes(std::span(&header, 1)))) {
    return false;
  }
  for (const auto& part : parts) {
    if (!file.write(part)) {
      return false;
    }
  }
  return file.flush();
}

} // namespace

CacheFileContent read_cache_file(const std::filesystem::path& path, const Digest& key) {
  // A pipe in place of the entry would be waited for.
  const OpenFile file(path, O_RDONLY | O_NONBLOCK);
  if (!file.is_open()) {
    return {errno == ENOENT ? CacheFileState::absent : CacheFileState::damaged, {}};
  }
  CacheFileContent result{CacheFileState::damaged, {}};
  Header header;
  const Header expected;
  const std::uint64_t size = file.size();
  if (size < sizeof(Header) || !file.read(std::as_writable_bytes(std::span(&header, 1))) ||
      header.mark != expected.mark || header.version != expected.version ||
      header.byte_order != expected.byte_order || header.key != key ||
      header.bytes != size - sizeof(Header)) {
    return result;
  }
  result.content.resize(header.bytes);
  if (file.read(result.content) && checksum(key, {result.content}) == header.checksum) {
    result.state = CacheFileState::whole;
  } else {
    result.content.clear();
  }
  return result;
}

std::string write_cache_file(const std::filesystem::path& path, const std::string& pending_suffix,
                             const Digest& key,
                             const std::vector<std::span<const std::byte>>& parts) {
  static std::atomic<unsigned> counter{0};
  Header header;
  header.key = key;
  for (const auto& part : parts) {
    header.bytes += part.size();
  }
  header.checksum = checksum(key, parts);
  const std::filesystem::path pending =
      path.parent_path() /
      fmt::format("{}-{}-{}{}", path.stem().string(), ::getpid(), counter++, pending_suffix);
  std::string failure;
  if (!write_all(pending, header, parts) || ::rename(pending.c_str(), path.c_str()) != 0) {
    failure = std::strerror(errno);
    ::unlink(pending.c_str());
  }
  return failure;
}

} // namespace ionskin::base
