// SPDX-License-Identifier: Apache-2.0
#include "studio/jobs/confinement.hpp"

#include "ionskin/base/system/installation.hpp"
#include "ionskin/base/text.hpp"
#include "studio/jobs/process.hpp"

#include <cstdint>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <linux/landlock.h>
#include <string>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <system_error>
#include <unistd.h>

namespace ionskin::apps::studio {
namespace {

namespace fs = std::filesystem;

constexpr long least_version = 2; // the first that lets a file be moved to another folder

constexpr std::uint64_t read = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
/// Rights to files that Landlock controls, except the right to execute: programs may be run from
/// anywhere, since they have no more rights than this process.
constexpr std::uint64_t everything =
    read | LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_REMOVE_DIR |
    LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_DIR |
    LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO |
    LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SYM | LANDLOCK_ACCESS_FS_REFER;

void allow(int rules, int folder, std::uint64_t access) {
  const landlock_path_beneath_attr rule{access, folder};
  if (::syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) != 0) {
    throw std::system_error(errno, std::generic_category(), "a program cannot be confined");
  }
}

/// Adds a rule that allows access below a folder; does nothing where the folder is missing.
void allow(int rules, const fs::path& folder, std::uint64_t access) {
  const base::FileDescriptor open(::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (open >= 0) {
    allow(rules, open, access);
  }
}

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

fs::path users_folder(const char* name, const char* in_home) {
  const std::string given = variable(name);
  return given.empty() ? fs::path(variable("HOME")) / in_home : fs::path(given);
}

/// Allows matplotlib, which draws reports, its settings and its font cache in folders of the user.
void allow_matplotlib(int rules) {
  if (const std::string own = variable("MPLCONFIGDIR"); !own.empty()) {
    allow(rules, fs::path(own), everything);
    return;
  }
  const fs::path cache = users_folder("XDG_CACHE_HOME", ".cache") / "matplotlib";
  std::error_code ignored;
  fs::create_directories(cache, ignored);
  allow(rules, cache, everything);
  allow(rules, users_folder("XDG_CONFIG_HOME", ".config") / "matplotlib", read);
}

} // namespace

bool Confinement::is_available() noexcept {
  return ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION) >=
         least_version;
}

Confinement::Confinement(const base::FileDescriptor& folder) {
  if (!is_available()) {
    return;
  }
  const landlock_ruleset_attr handled{everything};
  rules_ = base::FileDescriptor(
      static_cast<int>(::syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0)));
  if (rules_ < 0) {
    throw std::system_error(errno, std::generic_category(), "a program cannot be confined");
  }
  for (const char* system : {"/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32", "/etc",
                             "/opt", "/proc", "/sys"}) {
    allow(rules_, fs::path(system), read);
  }
  allow(rules_, fs::path("/dev"), everything);
  const base::Installation& own = base::installation();
  for (const fs::path& part :
       {program().parent_path(), own.solver.parent_path(), own.data, own.python}) {
    allow(rules_, part, read);
  }
  for (const char* replaced : {"IONSKIN_DATA", "IONSKIN_PYTHON_PATH"}) {
    allow(rules_, fs::path(variable(replaced)), read);
  }
  for (const std::string& libraries : base::split(variable("LD_LIBRARY_PATH"), ':', "")) {
    allow(rules_, fs::path(libraries), read);
  }
  allow_matplotlib(rules_);
  allow(rules_, static_cast<int>(folder), everything);
}

bool Confinement::enter() const noexcept {
  return rules_ < 0 || (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
                        ::syscall(SYS_landlock_restrict_self, static_cast<int>(rules_), 0) == 0);
}

} // namespace ionskin::apps::studio
