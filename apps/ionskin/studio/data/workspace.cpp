// SPDX-License-Identifier: Apache-2.0
#include "studio/data/workspace.hpp"

#include "ionskin/base/error.hpp"
#include "studio/data/state_folder.hpp"
#include "studio/server/http_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace ionskin::apps::studio {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_name = 80;

bool is_plain(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == '.';
}

/// True if the canonical path `path` is, or lies in, the canonical path `folder`.
bool lies_in(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

/// Normalises a path: removes ".", and ".." as far as it cancels; "." for an empty path.
fs::path plain_path(const std::string& relative) {
  const fs::path path = fs::path(relative).lexically_normal();
  return path.empty() ? fs::path(".") : path.has_filename() ? path : path.parent_path();
}

} // namespace

std::string name_below(const std::string& folder, const std::string& name) {
  const std::string whole = folder == "." ? name : folder + "/" + name;
  return whole.front() == '-' ? "./" + whole : whole;
}

Workspace::Workspace(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  root_ = fs::canonical(folder, error);
  if (error || !fs::is_directory(root_)) {
    throw UserError(
        fmt::format("{} is not a folder that can be used: {}\n  = name a folder for cases "
                    "and results: ionskin studio FOLDER",
                    folder.string(), error ? error.message() : "it is a file"));
  }
  folder_ = base::FileDescriptor(::open(root_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder_ < 0 || ::access(root_.c_str(), W_OK | X_OK) != 0) {
    throw UserError(fmt::format("{} cannot be written\n  = choose a folder of your own: ionskin "
                                "studio FOLDER",
                                root_.string()));
  }
  state_ = state_folder(root_);
  lock_ =
      base::FileDescriptor(::open((state_ / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
  if (lock_ < 0 || ::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    throw UserError(fmt::format("another Studio works in {}\n  = use its page, stop it with Ctrl-C "
                                "where it runs, or name another folder",
                                root_.string()));
  }
}

Opened Workspace::open(const std::string& relative) const {
  const fs::path name = plain_path(relative);
  const bool has_zero = relative.find('\0') != std::string::npos;
  if (has_zero || name.is_absolute() || *name.begin() == ".." || *name.begin() == brought_records ||
      lies_in(root_ / name, state_)) {
    throw HttpError(403, "this path lies outside the workspace");
  }
  Opened opened{open_below(folder_, name), name_below(".", name.string())};
  if (opened.file < 0 && (errno == ELOOP || errno == EXDEV)) {
    throw HttpError(403, "this path is a link, and the Studio follows none");
  }
  if (opened.file < 0) {
    throw HttpError(404, "there is no such file in the workspace");
  }
  return opened;
}

fs::path Workspace::place(const std::string& name) const {
  if (name.empty() || name.size() > longest_name || name.front() == '.' || name.front() == '-' ||
      !std::all_of(name.begin(), name.end(), is_plain)) {
    throw HttpError(400, "a name has letters, digits, '-', '_' and '.', 80 at most, and begins "
                         "with a letter or digit");
  }
  return root_ / name;
}

} // namespace ionskin::apps::studio
