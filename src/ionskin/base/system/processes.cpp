// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/system/processes.hpp"

#include <cerrno>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ionskin::base {

std::vector<char*> argument_pointers(std::vector<std::string>& words) {
  std::vector<char*> result;
  for (std::string& word : words) {
    result.push_back(word.data());
  }
  result.push_back(nullptr);
  return result;
}

pid_t start_program(std::vector<std::string> words, const ProcessOutputs& outputs) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (outputs.output >= 0) {
    posix_spawn_file_actions_adddup2(&actions, outputs.output, STDOUT_FILENO);
  }
  if (outputs.errors >= 0) {
    posix_spawn_file_actions_adddup2(&actions, outputs.errors, STDERR_FILENO);
  }
  pid_t child = -1;
  const int failure = posix_spawn(&child, words.front().c_str(), &actions, nullptr,
                                  argument_pointers(words).data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  errno = failure;
  return failure == 0 ? child : -1;
}

int wait_for_end(pid_t process) {
  constexpr int unknown = 127;
  int status = 0;
  pid_t ended = -1;
  do {
    ended = waitpid(process, &status, 0);
  } while (ended < 0 && errno == EINTR);
  if (ended < 0) { // no child, or someone else has waited for it
    return unknown;
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

} // namespace ionskin::base
