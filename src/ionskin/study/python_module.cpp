// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/python_module.hpp"

#include "ionskin/base/installation.hpp"

#include <cerrno>
#include <cstdlib>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace ionskin::study {
namespace {

/// The environment with PYTHONPATH put before any other.
std::vector<std::string> python_environment() {
  const char* package = std::getenv("IONSKIN_PYTHON_PATH");
  std::string path = package != nullptr ? package : base::installation().python.string();
  if (const char* existing = std::getenv("PYTHONPATH")) {
    path += std::string(":") + existing;
  }
  std::vector<std::string> result{"PYTHONPATH=" + path, "PYTHONDONTWRITEBYTECODE=1"};
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (text.rfind("PYTHONPATH=", 0) != 0 && text.rfind("PYTHONDONTWRITEBYTECODE=", 0) != 0) {
      result.push_back(text);
    }
  }
  return result;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) {
    result.push_back(text.data());
  }
  result.push_back(nullptr);
  return result;
}

} // namespace

std::string python_interpreter() {
  return IONSKIN_PYTHON;
}

int run_python_module(const std::string& module, const std::vector<std::string>& arguments) {
  std::vector<std::string> words{IONSKIN_PYTHON, "-m", module};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> environment = python_environment();
  pid_t child = 0;
  if (posix_spawn(&child, IONSKIN_PYTHON, nullptr, nullptr, pointers(words).data(),
                  pointers(environment).data()) != 0) {
    return -1;
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace ionskin::study
