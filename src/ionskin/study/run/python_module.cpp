// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/run/python_module.hpp"

#include "ionskin/base/system/file_descriptor.hpp"
#include "ionskin/base/system/installation.hpp"
#include "ionskin/base/system/processes.hpp"

#include <array>
#include <cerrno>
#include <charconv>
#include <fcntl.h>
#include <sstream>
#include <string_view>
#include <unistd.h>

namespace ionskin::study {
namespace {

constexpr int missing_library = 3; // exit status, as in isolated.py

/// Message after the last "error: " at the start of a line, or else the last line; line breaks are
/// replaced by spaces.
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

/// Removes complete lines "progress FRACTION" from a text and passes their fractions on.
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

/// Reads from a pipe until the other end is closed; returns the last 4096 bytes, without progress
/// lines.
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

} // namespace

bool PythonOutcome::lacks_library() const {
  return exit_code == missing_library;
}

namespace {

std::vector<std::string> command_of(const std::string& module,
                                    const std::vector<std::string>& arguments) {
  const std::string launcher = (base::python_package() / "ionskin" / "isolated.py").string();
  std::vector<std::string> words{base::python_interpreter(), "-I", "-B", launcher, module};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

} // namespace

void become_python_module(const std::string& module, const std::vector<std::string>& arguments) {
  std::vector<std::string> words = command_of(module, arguments);
  execv(words.front().c_str(), base::argument_pointers(words).data());
}

PythonOutcome run_python_module(const std::string& module,
                                const std::vector<std::string>& arguments, PythonErrors errors,
                                const PythonProgress& progress) {
  std::array<int, 2> ends{-1, -1};
  if (errors == PythonErrors::captured && ::pipe2(ends.data(), O_CLOEXEC) != 0) {
    ends = {-1, -1};
  }
  const base::FileDescriptor reading(ends[0]);
  base::FileDescriptor writing(ends[1]);
  const pid_t child = base::start_program(command_of(module, arguments), {.errors = writing});
  writing = base::FileDescriptor(); // so that reading ends with the child
  if (child < 0) {
    return {-1, ""};
  }
  PythonOutcome outcome;
  if (reading >= 0) {
    outcome.message = last_message(read_end(reading, progress));
  }
  outcome.exit_code = base::wait_for_end(child);
  return outcome;
}

} // namespace ionskin::study
