// SPDX-License-Identifier: Apache-2.0
#include "studio/data/open_below.hpp"

#include <cerrno>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>

namespace ionskin::apps::studio {
namespace {

mode_t kind_of(const base::FileDescriptor& open) {
  struct stat status {};
  return ::fstat(open, &status) == 0 ? status.st_mode & S_IFMT : 0;
}

} // namespace

base::FileDescriptor open_below(const base::FileDescriptor& folder,
                                const std::filesystem::path& name) {
  constexpr int flags = O_RDONLY | O_NONBLOCK | O_NOCTTY | O_NOFOLLOW | O_CLOEXEC;
  base::FileDescriptor at(::openat(folder, ".", flags));
  for (const std::filesystem::path& part : name) {
    if (part == ".." || part.is_absolute()) {
      errno = EXDEV;
      return base::FileDescriptor();
    }
    if (at >= 0 && !part.empty() && part != ".") {
      at = base::FileDescriptor(::openat(at, part.c_str(), flags));
    }
  }
  return at;
}

std::filesystem::path path_of(const base::FileDescriptor& open) {
  return "/proc/self/fd/" + std::to_string(static_cast<int>(open));
}

bool is_folder(const base::FileDescriptor& open) {
  return kind_of(open) == S_IFDIR;
}

bool is_file(const base::FileDescriptor& open) {
  return kind_of(open) == S_IFREG;
}

} // namespace ionskin::apps::studio
