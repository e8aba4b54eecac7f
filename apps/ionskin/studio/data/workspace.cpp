// SPDX-License-Identifier: Apache-2.0
#include "studio/data/workspace.hpp"

#include "ionskin/base/error.hpp"
#include "studio/server/http_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
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

/// True when `path` is `folder` or lies in it. Both are canonical.
bool lies_in(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

} // namespace

Workspace::Workspace(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  root_ = fs::canonical(folder, error);
  if (error || !fs::is_directory(root_)) {
    throw UserError(fmt::format("{} is no folder that can be used: {}\n  = name a folder for cases "
                                "and results: ionskin studio FOLDER",
                                folder.string(), error ? error.message() : "it is a file"));
  }
  if (fs::is_symlink(fs::symlink_status(state(), error))) {
    throw UserError(fmt::format("{} is a link; the Studio keeps its records there\n  = remove it",
                                state().string()));
  }
  fs::create_directories(state() / "jobs", error);
  lock_ = ::open((state() / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (lock_ < 0) {
    throw UserError(fmt::format("{} cannot be written\n  = choose a folder of your own: ionskin "
                                "studio FOLDER",
                                root_.string()));
  }
  if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    throw UserError(fmt::format("another Studio works in {}\n  = use its page, stop it with Ctrl-C "
                                "where it runs, or name another folder",
                                root_.string()));
  }
}

Workspace::~Workspace() {
  if (lock_ >= 0) {
    ::close(lock_);
  }
}

fs::path Workspace::inside(const std::string& relative) const {
  if (relative.find('\0') != std::string::npos || fs::path(relative).is_absolute()) {
    throw HttpError(403, "paths are relative to the workspace");
  }
  std::error_code error;
  const fs::path path = fs::canonical(root_ / relative, error);
  // What lies outside is refused before one learns whether it is there.
  const fs::path known = error ? fs::weakly_canonical(root_ / relative, error) : path;
  if (known.empty() || !lies_in(known, root_) || lies_in(known, state())) {
    throw HttpError(403, "this path lies outside the workspace");
  }
  if (path.empty()) {
    throw HttpError(404, "there is no such file in the workspace");
  }
  return path;
}

std::string Workspace::relative(const fs::path& path) const {
  const std::string name = path.lexically_relative(root_).generic_string();
  return name.front() == '-' ? "./" + name : name; // else a program would take it for an option
}

fs::path Workspace::place(const std::string& name) const {
  if (name.empty() || name.size() > longest_name || name.front() == '.' || name.front() == '-' ||
      !std::all_of(name.begin(), name.end(), is_plain)) {
    throw HttpError(400, "a name has letters, digits, '-', '_' and '.', 80 at most, and begins "
                         "with a letter or digit");
  }
  return root_ / name;
}

std::string Workspace::free_name(const std::string& wanted) const {
  const auto taken = [this](const std::string& name) {
    std::error_code error;
    return fs::exists(fs::symlink_status(place(name), error)) ||
           fs::exists(fs::symlink_status(place(name + ".toml"), error));
  };
  std::string name = wanted;
  for (int number = 2; taken(name); ++number) {
    name = fmt::format("{}-{}", wanted, number);
  }
  return name;
}

std::string plain_name(const std::string& title) {
  std::string name;
  for (const char c : title) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!name.empty() && name.back() != '-') {
      name += '-';
    }
  }
  name = name.substr(0, 40);
  while (!name.empty() && name.back() == '-') {
    name.pop_back();
  }
  return name.empty() ? "run" : name;
}

} // namespace ionskin::apps::studio
