// SPDX-License-Identifier: Apache-2.0

// The front of the program. It parses the command line, answers the quick verbs itself and hands
// the others to `ionskin-solver`, whose libraries take half a second to load.

#include "command_line/command_line.hpp"
#include "command_line/guard.hpp"
#include "command_line/manual_page.hpp"
#include "verbs/cache.hpp"
#include "verbs/check.hpp"
#include "verbs/cite.hpp"
#include "verbs/doctor.hpp"
#include "verbs/init.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/installation.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace {

/// Replaces this process by another program of ionskin in the same folder, with the same arguments.
/// Throws UserError when the program cannot be started, as in a build that lacks it.
int become(const char* name, char** argv) {
  const auto program = ionskin::base::installation().solver.parent_path() / name;
  const auto self = std::filesystem::canonical("/proc/self/exe");
  setenv("IONSKIN_FRONT", self.c_str(), 1); // for parts that start further commands
  execv(program.c_str(), argv);
  throw ionskin::UserError(
      "cannot start " + program.string() +
      ", the part of ionskin that does this: " + std::strerror(errno) +
      "\n  = in a build tree, make build builds every part; else install the package again");
}

} // namespace

int main(int argc, char** argv) {
  using namespace ionskin::apps;
  return guarded([&]() -> int {
    int exit_code = 0;
    const auto command = parse_command_line(argc, argv, exit_code);
    if (!command) {
      return exit_code;
    }
    if (std::holds_alternative<DoctorOptions>(*command)) {
      return doctor();
    }
    if (const auto* cache_options = std::get_if<CacheOptions>(&*command)) {
      return cache(*cache_options);
    }
    if (const auto* cite_options = std::get_if<CiteOptions>(&*command)) {
      return cite(*cite_options);
    }
    if (std::holds_alternative<ManualOptions>(*command)) {
      return manual_page();
    }
    if (const auto* key_options = std::get_if<KeysOptions>(&*command)) {
      return keys(*key_options);
    }
    if (const auto* completion_options = std::get_if<CompletionOptions>(&*command)) {
      return completion(*completion_options);
    }
    if (std::holds_alternative<StudioOptions>(*command)) {
      return become("ionskin-studio", argv);
    }
    if (std::holds_alternative<LiveOptions>(*command) ||
        std::holds_alternative<VerifyOptions>(*command)) {
      return become("ionskin-extras", argv);
    }
    require_vector_instructions();
    if (const auto* init_options = std::get_if<InitOptions>(&*command)) {
      return init(*init_options);
    }
    if (const auto* check_options = std::get_if<CheckOptions>(&*command)) {
      if (check(*check_options)) {
        return 0;
      }
    }
    return become("ionskin-solver", argv);
  });
}
