// SPDX-License-Identifier: Apache-2.0
#include "studio/server/link_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

namespace ionskin::apps::studio {
namespace {

namespace fs = std::filesystem;

/// Makes a new folder that only this user can enter.
fs::path own_folder() {
  const char* const runtime = std::getenv("XDG_RUNTIME_DIR");
  const bool usable =
      runtime != nullptr && runtime[0] == '/' && ::access(runtime, W_OK | X_OK) == 0;
  const fs::path parent = usable ? fs::path(runtime) : fs::temp_directory_path();
  std::string folder = (parent / "ionskin-studio-XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) {
    throw std::system_error(errno, std::generic_category(), folder);
  }
  return folder;
}

void write_for_user(const fs::path& path, const std::string& text) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0600);
  const bool whole =
      file >= 0 && ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  const int reason = errno;
  if (file >= 0) {
    ::close(file);
  }
  if (!whole) {
    throw std::system_error(reason, std::generic_category(), path.string());
  }
}

} // namespace

LinkFile::LinkFile(const std::string& link) : folder_(own_folder()) {
  try {
    write_for_user(path(), fmt::format("<!DOCTYPE html>\n<meta charset=\"utf-8\">\n"
                                       "<meta http-equiv=\"refresh\" content=\"0; url={0}\">\n"
                                       "<title>ionskin studio</title>\n"
                                       "<a href=\"{0}\">Open the Studio</a>\n",
                                       link));
  } catch (const std::system_error&) {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
    throw;
  }
}

LinkFile::~LinkFile() {
  std::error_code ignored;
  fs::remove(path(), ignored);
  fs::remove(folder_, ignored);
}

} // namespace ionskin::apps::studio
