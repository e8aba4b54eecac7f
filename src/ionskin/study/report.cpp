// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/report.hpp"

#include <fmt/core.h>

#include <array>
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
  std::string path = package != nullptr ? package : IONSKIN_PYTHON_PATH;
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

/// @param product what the module makes, for messages
std::optional<std::string> run_module(const std::string& module,
                                      const std::filesystem::path& folder,
                                      const std::string& product) {
  std::vector<std::string> arguments{IONSKIN_PYTHON, "-m", module, folder.string()};
  std::vector<std::string> environment = python_environment();
  const std::string remedy =
      fmt::format("install python3-numpy, python3-h5py and python3-matplotlib, then run: "
                  "{} -m {} {}",
                  IONSKIN_PYTHON, module, folder.string());
  pid_t child = 0;
  if (posix_spawn(&child, IONSKIN_PYTHON, nullptr, nullptr, pointers(arguments).data(),
                  pointers(environment).data()) != 0) {
    return fmt::format("No {} was made: {} cannot be started. Remedy: {}", product, IONSKIN_PYTHON,
                       remedy);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    return fmt::format("No {} was made: its script failed (see above). Remedy: {}", product,
                       remedy);
  }
  return std::nullopt;
}

} // namespace

std::optional<std::string> make_report(const std::filesystem::path& folder) {
  return run_module("ionskin.report", folder, "report");
}

std::optional<std::string> draw_impedance(const std::filesystem::path& folder) {
  return run_module("ionskin.impedance", folder, "figure");
}

} // namespace ionskin::study
