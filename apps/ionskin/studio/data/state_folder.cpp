// SPDX-License-Identifier: Apache-2.0
#include "studio/data/state_folder.hpp"

#include "ionskin/base/digest.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/files/read_text_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sys/stat.h>
#include <unistd.h>

namespace ionskin::apps::studio {

namespace fs = std::filesystem;

namespace {

fs::path users_state() {
  const char* named = std::getenv("XDG_STATE_HOME");
  if (named != nullptr && fs::path(named).is_absolute()) {
    return named;
  }
  const char* home = std::getenv("HOME");
  if (home != nullptr && fs::path(home).is_absolute()) {
    return fs::path(home) / ".local" / "state";
  }
  throw UserError("there is no place for the Studio's records: HOME is not set\n  = set HOME, or "
                  "XDG_STATE_HOME to a folder of your own");
}

/// Makes a folder if it is missing, and requires that it is no link, belongs to this user, and that
/// nobody else can write in it.
void make_private(const fs::path& folder) {
  struct stat status {};
  if ((::mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) ||
      ::lstat(folder.c_str(), &status) != 0) {
    throw UserError(fmt::format("the folder {} of the Studio's records cannot be made: {}\n  = set "
                                "XDG_STATE_HOME to a folder of your own",
                                folder.string(), std::strerror(errno)));
  }
  if (!S_ISDIR(status.st_mode) || status.st_uid != ::geteuid() ||
      (status.st_mode & (S_IWGRP | S_IWOTH)) != 0) {
    throw UserError(fmt::format("{} is not a folder in which you alone write, and the Studio runs "
                                "commands that are recorded there\n  = remove it, or set "
                                "XDG_STATE_HOME to a folder of your own",
                                folder.string()));
  }
}

} // namespace

fs::path state_folder(const fs::path& workspace) {
  fs::path folder = users_state();
  std::error_code error; // of which the next folder tells
  fs::create_directories(folder, error);
  const std::string name =
      base::DigestBuilder().add(std::string_view(workspace.native())).finish().hex();
  for (const std::string& part : {std::string("ionskin"), std::string("studio"), name}) {
    folder /= part;
    make_private(folder);
  }
  make_private(folder / "jobs");
  // Digests of two paths could be made to agree, by somebody who chooses one of them.
  const fs::path owner = folder / "workspace";
  if (!fs::exists(owner)) {
    base::write_text_file(owner, workspace.native());
  }
  if (base::read_text_file(owner, "record") != workspace.native()) {
    throw UserError(
        fmt::format("{} holds the records of another workspace\n  = remove it, or rename "
                    "the workspace",
                    folder.string()));
  }
  return fs::canonical(folder);
}

} // namespace ionskin::apps::studio
