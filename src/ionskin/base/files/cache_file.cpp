// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/files/cache_file.hpp"

#include "ionskin/base/files/atomic_file.hpp"

#include <array>
#include <cerrno>
#include <fcntl.h>
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
      : descriptor_(::open(path.c_str(), flags | O_CLOEXEC)) {}
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
    return ::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode)
               ? static_cast<std::uint64_t>(status.st_size)
               : 0;
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

private:
  int descriptor_;
};

} // namespace

CacheFileContent read_cache_file(const std::filesystem::path& path, const Digest& key) {
  // Neither a link nor a pipe under the name of an entry is one.
  const OpenFile file(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
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

std::string write_cache_file(const std::filesystem::path& path, const Digest& key,
                             const std::vector<std::span<const std::byte>>& parts) {
  Header header;
  header.key = key;
  for (const auto& part : parts) {
    header.bytes += part.size();
  }
  header.checksum = checksum(key, parts);
  try {
    PendingFile file(path);
    file.write(std::as_bytes(std::span(&header, 1)));
    for (const auto& part : parts) {
      file.write(part);
    }
    file.commit();
    return "";
  } catch (const UnwritableFile& failure) {
    return failure.reason();
  }
}

} // namespace ionskin::base
