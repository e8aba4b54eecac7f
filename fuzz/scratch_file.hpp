// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstdio>
#include <fcntl.h>
#include <string>
#include <unistd.h>

namespace ionskin::fuzz {

/// A file in memory with the given bytes, for readers that take a path.
class ScratchFile {
public:
  ScratchFile(const std::uint8_t* data, std::size_t size) {
    const std::string pattern = "/dev/shm/ionskin-fuzz-XXXXXX";
    path_ = pattern;
    const int file = mkstemp(path_.data());
    if (file < 0 || write(file, data, size) != static_cast<ssize_t>(size))
      std::perror("scratch file");
    close(file);
  }
  ~ScratchFile() { unlink(path_.c_str()); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  const std::string& path() const { return path_; }

private:
  std::string path_;
};

} // namespace ionskin::fuzz
