// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/run/python_module.hpp"

#include "ionskin/base/system/installation.hpp"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <fcntl.h>
#include <spawn.h>
#include <sstream>
#include <string_view>
#include <sys/wait.h>
#include <unistd.h>

namespace ionskin::study {
namespace {

constexpr int missing_library = 3; // as in isolated.py

std::string launcher() {
  const char* package = std::getenv("IONSKIN_PYTHON_PATH");
  const bool given = package != nullptr && *package != '\0';
  return (given ? package : base::installation().python.string()) +
         std::string("/ionskin/isolated.py");
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) {
    result.push_back(text.data());
  }
  result.push_back(nullptr);
  return result;
}

/// What stands behind the last "error: " at the begin of a line, or else the last line; as one
/// line.
std::string last_message(std::string text) {
  constexpr std::string_view mark = "error: ";
  const std::size_t found = text.rfind("\n" + std::string(mark));
  if (found != std::string::npos) {
    text.erase(0, found + 1 + mark.size());
  } else if (text.starts_with(mark)) {
    text.erase(0, mark.size());
  } else {
    const std::size_t end = text.find_last_not_of('\n');
    const std::size_t before = end == std::string::npos ? end : text.rfind('\n', end);
    text.erase(0, before == std::string::npos ? 0 : before + 1);
  }
  std::istringstream words(text);
  std::string result, word;
  while (words >> word) {
    result += (result.empty() ? "" : " ") + word;
  }
  return result;
}

/// Takes the lines "progress PART" that are whole out of a text.
void take_progress(std::string& text, const PythonProgress& progress) {
  constexpr std::string_view mark = "progress ";
  for (std::size_t begin = 0, end = 0; (end = text.find('\n', begin)) != std::string::npos;) {
    const std::string line = text.substr(begin, end - begin);
    double part = 0;
    const char* number = line.data() + mark.size();
    const char* last = line.data() + line.size();
    if (line.starts_with(mark) && std::from_chars(number, last, part).ptr == last && part >= 0 &&
        part <= 1) {
      progress(part);
      text.erase(begin, end + 1 - begin);
    } else {
      begin = end + 1;
    }
  }
}

/// Reads until the other end is closed, keeping the end of what came.
std::string read_end(int descriptor, const PythonProgress& progress) {
  constexpr std::size_t most = 4096;
  std::string text;
  std::array<char, 1024> buffer;
  while (true) {
    const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
    if (count > 0) {
      text.append(buffer.data(), static_cast<std::size_t>(count));
      if (progress) {
        take_progress(text, progress);
      }
      text.erase(0, text.size() > most ? text.size() - most : 0);
    } else if (count == 0 || errno != EINTR) {
      return text;
    }
  }
}

/// Standard error of a child, on its way here.
class ErrorPipe {
public:
  ErrorPipe(PythonErrors errors, posix_spawn_file_actions_t& actions) {
    if (errors == PythonErrors::captured && ::pipe2(ends_.data(), O_CLOEXEC) == 0) {
      posix_spawn_file_actions_adddup2(&actions, ends_[1], STDERR_FILENO);
    }
  }
  ~ErrorPipe() {
    close_end(0);
    close_end(1);
  }
  ErrorPipe(const ErrorPipe&) = delete;
  ErrorPipe& operator=(const ErrorPipe&) = delete;

  std::string message(const PythonProgress& progress) {
    close_end(1);
    return ends_[0] >= 0 ? last_message(read_end(ends_[0], progress)) : "";
  }

private:
  void close_end(std::size_t i) {
    if (ends_[i] >= 0) {
      ::close(ends_[i]);
      ends_[i] = -1;
    }
  }
  std::array<int, 2> ends_{-1, -1};
};

} // namespace

std::string python_interpreter() {
  const char* given = std::getenv("IONSKIN_PYTHON"); // of a wheel: that which it is installed for
  return given != nullptr && *given != '\0' ? given : IONSKIN_PYTHON;
}

bool PythonOutcome::lacks_library() const {
  return exit_code == missing_library;
}

namespace {

std::vector<std::string> command_of(const std::string& module,
                                    const std::vector<std::string>& arguments) {
  std::vector<std::string> words{python_interpreter(), "-I", "-B", launcher(), module};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

} // namespace

void become_python_module(const std::string& module, const std::vector<std::string>& arguments) {
  std::vector<std::string> words = command_of(module, arguments);
  execv(IONSKIN_PYTHON, pointers(words).data());
}

PythonOutcome run_python_module(const std::string& module,
                                const std::vector<std::string>& arguments, PythonErrors errors,
                                const PythonProgress& progress) {
  std::vector<std::string> words = command_of(module, arguments);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  PythonOutcome outcome;
  {
    ErrorPipe pipe(errors, actions);
    pid_t child = 0;
    const int failure =
        posix_spawn(&child, IONSKIN_PYTHON, &actions, nullptr, pointers(words).data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failure != 0) {
      return {-1, ""};
    }
    outcome.message = pipe.message(progress);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  return outcome;
}

} // namespace ionskin::study
