// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/system/available_memory.hpp"

#include "ionskin/base/byte_count.hpp"

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <optional>
#include <sys/resource.h>
#include <unistd.h>

namespace ionskin::base {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Number behind a name in a file of lines "name number", in the unit of the file. Nothing
/// (`nullopt`) when the file or the name is missing.
std::optional<double> field(const char* file, const std::string& name) {
  std::ifstream stream(file);
  std::string key;
  for (double value = 0; stream >> key >> value; stream.ignore(1000, '\n')) {
    if (key == name) {
      return value;
    }
  }
  return std::nullopt;
}

std::optional<double> number_in(const std::string& file) {
  std::ifstream stream(file);
  double value = 0;
  return stream >> value ? std::optional(value) : std::nullopt;
}

double free_on_machine() {
  const auto kilobytes = field("/proc/meminfo", "MemAvailable:");
  return kilobytes ? 1024 * *kilobytes : unlimited;
}

/// Memory that the limit of the control group leaves to this process [bytes]: version 2 of control
/// groups, else version 1, at the paths that a container sees. Inactive pages of files count as
/// free, because the system releases them when memory is short.
double left_in_control_group() {
  struct Files {
    const char *limit, *usage, *statistics, *cached;
  };
  for (const Files& files : {Files{"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current",
                                   "/sys/fs/cgroup/memory.stat", "inactive_file"},
                             Files{"/sys/fs/cgroup/memory/memory.limit_in_bytes",
                                   "/sys/fs/cgroup/memory/memory.usage_in_bytes",
                                   "/sys/fs/cgroup/memory/memory.stat", "total_inactive_file"}}) {
    const auto limit = number_in(files.limit), usage = number_in(files.usage);
    if (limit && usage) {
      return *limit - *usage + field(files.statistics, files.cached).value_or(0.0);
    }
  }
  return unlimited;
}

double left_of_address_space() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) {
    return unlimited;
  }
  const double used =
      number_in("/proc/self/statm").value_or(0.0) * static_cast<double>(sysconf(_SC_PAGESIZE));
  return static_cast<double>(limit.rlim_cur) - used;
}

} // namespace

AvailableMemory available_memory() {
  if (const char* given = std::getenv("IONSKIN_MEMORY_LIMIT"); given != nullptr && *given != '\0') {
    return {static_cast<double>(byte_count("IONSKIN_MEMORY_LIMIT", given)),
            "allowed by IONSKIN_MEMORY_LIMIT"};
  }
  AvailableMemory least{free_on_machine(), "free on this machine"};
  if (const double left = left_in_control_group(); left < least.bytes) {
    least = {left, "left by the limit of the control group (container or job)"};
  }
  if (const double left = left_of_address_space(); left < least.bytes) {
    least = {left, "left by the limit of the address space (ulimit -v)"};
  }
  return least;
}

} // namespace ionskin::base
