// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/files/read_text_file.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/text.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ionskin::base {

namespace {

[[noreturn]] void refuse_unreadable(const std::string& what, const std::string& path) {
  throw UserError(
      fmt::format("the {} file {} cannot be read: {}\n  = check its name and its permissions", what,
                  shown(path), std::strerror(errno)));
}

void require_ordinary(const struct stat& status, const std::string& what, const std::string& path) {
  if (S_ISDIR(status.st_mode))
    throw UserError(fmt::format("the {} file {} is a folder\n  = name a file", what, shown(path)));
  if (!S_ISREG(status.st_mode))
    throw UserError(fmt::format("the {} file {} is a pipe or a device\n  = save what comes from it "
                                "to a file, and name that",
                                what, shown(path)));
}

void require_size(std::size_t size, std::size_t most, const std::string& what,
                  const std::string& path) {
  if (size > most)
    throw UserError(fmt::format("the {} file {} has more than {} bytes, the most that one may "
                                "have\n  = name the right file, or keep fewer rows in it",
                                what, shown(path), most));
}

} // namespace

std::string read_text_file(const std::string& path, const std::string& what, std::size_t most) {
  if (path.find('\0') != std::string::npos)
    throw UserError(fmt::format("the name of the {} file holds a zero byte: {}\n  = check its name",
                                what, shown(path)));
  // Without O_NONBLOCK, opening a pipe would wait for its other end.
  return read_text_file(FileDescriptor(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)), path,
                        what, most);
}

std::string read_text_file(const FileDescriptor& file, const std::string& path,
                           const std::string& what, std::size_t most) {
  struct stat status {};
  if (file < 0 || fstat(file, &status) != 0)
    refuse_unreadable(what, path);
  require_ordinary(status, what, path);
  require_size(static_cast<std::size_t>(status.st_size), most, what, path);
  std::string text;
  std::array<char, 1U << 16> block{};
  for (;;) {
    const ssize_t count = read(file, block.data(), block.size());
    if (count < 0 && errno != EINTR)
      refuse_unreadable(what, path);
    if (count == 0)
      return text;
    if (count > 0)
      text.append(block.data(), static_cast<std::size_t>(count));
    require_size(text.size(), most, what, path); // files of /proc report size 0
  }
}

} // namespace ionskin::base
