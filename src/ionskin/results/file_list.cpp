// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/file_list.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/files/read_text_file.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sstream>
#include <system_error>
#include <unistd.h>

namespace ionskin::results {
namespace {

namespace fs = std::filesystem;

constexpr const char* heading =
    "# What ionskin wrote here: --overwrite removes these files and no others.\n";

} // namespace

bool is_inner_name(const std::string& name) {
  const fs::path path(name);
  const auto parts = std::distance(path.begin(), path.end());
  return !name.empty() && path.is_relative() && parts <= 2 && path.lexically_normal() == path &&
         *path.begin() != ".." && *path.begin() != "." && path.has_filename();
}

std::optional<std::set<std::string>> read_file_list(const fs::path& folder) {
  const fs::path path = folder / file_list_name;
  const base::FileDescriptor file(
      ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC));
  try {
    std::istringstream lines(base::read_text_file(file, path.string(), "list of results"));
    std::set<std::string> names;
    for (std::string line; std::getline(lines, line);) {
      if (is_inner_name(line)) {
        names.insert(line);
      }
    }
    return names;
  } catch (const UserError&) {
    return std::nullopt; // missing, a link, or not a file that a run wrote
  }
}

void add_to_file_list(const fs::path& folder, const std::string& name) {
  const fs::path path = folder / file_list_name;
  const int list = ::open(path.c_str(), O_WRONLY | O_APPEND | O_NOFOLLOW | O_CLOEXEC);
  if (list < 0) {
    throw base::UnwritableFile(path, std::strerror(errno));
  }
  // Starts on a new line, since a power cut may have left an incomplete one.
  const std::string text = "\n" + name + "\n";
  const ssize_t count = ::write(list, text.data(), text.size());
  const bool written = count == static_cast<ssize_t>(text.size()) && ::fsync(list) == 0;
  const int reason = count >= 0 && count < static_cast<ssize_t>(text.size()) ? ENOSPC : errno;
  ::close(list);
  if (!written) {
    throw base::UnwritableFile(path, std::strerror(reason));
  }
}

void clear_file_list(const fs::path& folder) {
  base::write_text_file(folder / file_list_name, heading);
}

} // namespace ionskin::results
