// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/files/file_copy.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/available_memory.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <vector>

namespace ionskin::base {
namespace {

constexpr std::size_t block_bytes = 1u << 20;

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw UserError(
      fmt::format("the file {} cannot be read: {}\n  = check its name and its permissions",
                  path.string(), std::strerror(error)));
}

const char* kind_of(mode_t mode) {
  if (S_ISDIR(mode)) {
    return "folder";
  }
  if (S_ISFIFO(mode)) {
    return "pipe";
  }
  return S_ISSOCK(mode) ? "socket" : "device";
}

struct RegularFile {
  FileDescriptor descriptor;
  struct stat status {};
};

RegularFile open_regular(const std::filesystem::path& path) {
  // Without O_NONBLOCK, opening a pipe waits for its writer.
  RegularFile file{FileDescriptor(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)),
                   {}};
  if (file.descriptor < 0 || fstat(file.descriptor, &file.status) != 0) {
    fail(path, errno);
  }
  if (!S_ISREG(file.status.st_mode)) {
    throw UserError(fmt::format("{} is a {}, not a file\n  = name a regular file", path.string(),
                                kind_of(file.status.st_mode)));
  }
  return file;
}

bool same_content(const struct stat& a, const struct stat& b) {
  return a.st_size == b.st_size && a.st_mtim.tv_sec == b.st_mtim.tv_sec &&
         a.st_mtim.tv_nsec == b.st_mtim.tv_nsec;
}

/// Reads a file block by block, passes every block to `take` and returns the digest of all bytes.
template <class Take>
Digest read_through(const std::filesystem::path& path, const RegularFile& file, const Take& take) {
  DigestBuilder digest;
  std::vector<std::byte> block(block_bytes);
  off_t place = 0;
  for (;;) {
    const ssize_t got = pread(file.descriptor, block.data(), block.size(), place);
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got < 0) {
      fail(path, errno);
    }
    if (got == 0 || place + got > file.status.st_size) {
      break;
    }
    const std::span<const std::byte> part(block.data(), static_cast<std::size_t>(got));
    digest.add_bytes(part);
    take(part);
    place += got;
  }
  struct stat now {};
  if (fstat(file.descriptor, &now) != 0 || place != file.status.st_size ||
      !same_content(file.status, now)) {
    throw UserError(fmt::format("{} changes while it is read\n  = wait until it is written, or "
                                "name a copy of it",
                                path.string()));
  }
  return digest.finish();
}

void append(int target, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(target, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) {
      throw UserError(fmt::format("not enough memory to read a file: {}\n  = free memory, or name "
                                  "a smaller file",
                                  std::strerror(errno)));
    }
    bytes = bytes.subspan(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
  }
}

} // namespace

FileCopy::FileCopy(const std::filesystem::path& path) {
  const RegularFile file = open_regular(path);
  bytes_ = static_cast<std::uint64_t>(file.status.st_size);
  const auto most = static_cast<std::uint64_t>(std::min(available_memory().bytes / 2, 1e18));
  if (bytes_ > most) {
    throw UserError(fmt::format(
        "{} has {:.3g} GB, and {:.3g} GB of memory are free for its copy\n  = leave "
        "out what is not needed of it, or free memory",
        path.string(), static_cast<double>(bytes_) * 1e-9, static_cast<double>(most) * 1e-9));
  }
  descriptor_ = FileDescriptor(memfd_create("ionskin-copy", MFD_CLOEXEC));
  if (descriptor_ < 0) {
    throw UserError(fmt::format("not enough memory to read {}: {}\n  = free memory", path.string(),
                                std::strerror(errno)));
  }
  digest_ = read_through(path, file,
                         [this](std::span<const std::byte> part) { append(descriptor_, part); });
  lseek(descriptor_, 0, SEEK_SET);
}

Digest file_digest(const std::filesystem::path& path) {
  return read_through(path, open_regular(path), [](std::span<const std::byte>) {});
}

} // namespace ionskin::base
