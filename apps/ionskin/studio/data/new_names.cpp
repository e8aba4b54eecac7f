// SPDX-License-Identifier: Apache-2.0
#include "studio/data/new_names.hpp"

#include "ionskin/base/files/atomic_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ionskin::apps::studio {
namespace {

std::string numbered(const std::string& wanted, int number) {
  return number == 1 ? wanted : fmt::format("{}-{}", wanted, number);
}

std::string case_of(const std::string& name) {
  return name + ".toml";
}

/// True if a file, folder or link of the name exists; a link counts even where its target is
/// missing.
bool is_there(const Workspace& workspace, const std::string& name) {
  struct stat status {};
  return ::fstatat(workspace.folder(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0;
}

/// True if a system call that makes a file or folder succeeded, false if the name exists already.
/// Throws UnwritableFile for other errors.
/// @param result result of the system call
bool made(const Workspace& workspace, const std::string& name, int result) {
  if (result < 0 && errno != EEXIST) {
    throw base::UnwritableFile(workspace.place(name), std::strerror(errno));
  }
  return result >= 0;
}

bool make_file(const Workspace& workspace, const std::string& name) {
  const base::FileDescriptor file(::openat(workspace.folder(), name.c_str(),
                                           O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
                                           0666));
  return made(workspace, name, file);
}

} // namespace

std::string free_name(const Workspace& workspace, const std::string& wanted) {
  for (int number = 1;; ++number) {
    const std::string name = workspace.place(numbered(wanted, number)).filename().string();
    if (!is_there(workspace, name) && !is_there(workspace, case_of(name))) {
      return name;
    }
  }
}

NewResults::NewResults(const Workspace& workspace, const std::string& wanted,
                       const std::string* case_text)
    : workspace_(workspace) {
  try {
    for (int number = 1; !take(numbered(wanted, number), case_text != nullptr); ++number) {
    }
    if (case_text != nullptr) {
      base::write_text_file(workspace_.place(case_of(name_)), *case_text);
    }
  } catch (...) {
    give_back();
    throw;
  }
}

NewResults::~NewResults() {
  if (!kept_) {
    give_back();
  }
}

bool NewResults::take(const std::string& name, bool with_case) {
  name_ = workspace_.place(name).filename().string();
  has_folder_ = made(workspace_, name_, ::mkdirat(workspace_.folder(), name_.c_str(), 0777));
  if (has_folder_ && with_case) {
    has_case_ = make_file(workspace_, case_of(name_));
  }
  const bool taken = has_folder_ && (with_case ? has_case_ : !is_there(workspace_, case_of(name_)));
  if (!taken) {
    give_back();
  }
  return taken;
}

void NewResults::give_back() {
  if (has_case_) {
    ::unlinkat(workspace_.folder(), case_of(name_).c_str(), 0);
  }
  if (has_folder_) {
    ::unlinkat(workspace_.folder(), name_.c_str(), AT_REMOVEDIR); // an empty one alone
  }
  has_case_ = has_folder_ = false;
}

std::string write_new_file(const Workspace& workspace, const std::string& stem,
                           const std::string& extension, std::string_view text) {
  for (int number = 1;; ++number) {
    const std::string name = numbered(stem, number) + extension;
    const auto path = workspace.place(name);
    if (make_file(workspace, name)) {
      try {
        base::write_text_file(path, text);
      } catch (...) {
        ::unlinkat(workspace.folder(), name.c_str(), 0);
        throw;
      }
      return name;
    }
  }
}

} // namespace ionskin::apps::studio
