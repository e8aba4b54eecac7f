// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/system/installation.hpp"

#include <cstdlib>
#include <dlfcn.h>
#include <link.h>
#include <optional>
#include <string>

namespace ionskin::base {
namespace {

namespace fs = std::filesystem;

/// Installation prefix, if the folder `own` is prefix/`place`; otherwise nothing (`nullopt`).
std::optional<fs::path> prefix_of(const fs::path& own, const fs::path& place) {
  fs::path prefix = own;
  for (fs::path rest = place; !rest.empty(); rest = rest.parent_path()) {
    if (prefix.filename() != rest.filename()) {
      return std::nullopt;
    }
    prefix = prefix.parent_path();
  }
  return prefix;
}

Installation installed(const fs::path& prefix) {
  return {prefix / IONSKIN_LIBEXEC_FOLDER / "ionskin-solver", prefix / IONSKIN_DATA_FOLDER,
          prefix / IONSKIN_PYTHON_FOLDER};
}

Installation find() {
  const fs::path own = own_file().parent_path();
  for (const char* place : {IONSKIN_BIN_FOLDER, IONSKIN_LIBEXEC_FOLDER, IONSKIN_LIBRARY_FOLDER,
                            IONSKIN_PYTHON_FOLDER}) {
    if (const auto prefix = prefix_of(own, place)) {
      const Installation here = installed(*prefix);
      if (fs::is_directory(here.data)) {
        return here;
      }
    }
  }
  const fs::path source = IONSKIN_SOURCE_FOLDER;
  // In the build tree, the solver for Python lies beside a link to the package.
  const fs::path built = own / "python";
  return {own / "ionskin-solver", source,
          fs::is_directory(built / "ionskin") ? built : source / "python"};
}

/// Value of an environment variable; empty if it is not set.
std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

} // namespace

std::string python_interpreter() {
  const std::string given = variable("IONSKIN_PYTHON");
  return given.empty() ? IONSKIN_PYTHON : given;
}

fs::path python_package() {
  const fs::path given = variable("IONSKIN_PYTHON_PATH");
  return given.empty() ? installation().python : given;
}

fs::path own_file() {
  static const char anchor = 0;
  Dl_info info{};
  link_map* map = nullptr;
  std::error_code error;
  // The program itself has an empty name there, and the name that it was called by may be anything.
  if (dladdr1(&anchor, &info, reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP) != 0 &&
      map != nullptr && *map->l_name != '\0') {
    return fs::canonical(map->l_name, error);
  }
  return fs::canonical("/proc/self/exe", error);
}

const Installation& installation() {
  static const Installation found = find();
  return found;
}

} // namespace ionskin::base
