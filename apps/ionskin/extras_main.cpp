// SPDX-License-Identifier: Apache-2.0

// The verbs that train and verify; started by `ionskin` with the same arguments.

#include "command_line/command_line.hpp"
#include "command_line/guard.hpp"
#include "study_verbs/live.hpp"
#include "study_verbs/verify.hpp"
#include "terminal/terminal.hpp"

#include "ionskin/base/system/free_memory.hpp"

int main(int argc, char** argv) {
  using namespace ionskin::apps;
  return guarded([&]() -> int {
    require_vector_instructions();
    ionskin::base::keep_freed_blocks();
    int exit_code = 0;
    const auto command = parse_command_line(argc, argv, exit_code);
    if (!command) {
      return exit_code;
    }
    if (const auto* live_options = std::get_if<LiveOptions>(&*command)) {
      return live(*live_options, command_as_typed(argc, argv));
    }
    return verify(std::get<VerifyOptions>(*command));
  });
}
