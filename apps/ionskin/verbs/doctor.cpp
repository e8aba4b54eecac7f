// SPDX-License-Identifier: Apache-2.0
#include "verbs/doctor.hpp"

#include "command_line/guard.hpp"
#include "command_line/threads.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/system/file_descriptor.hpp"
#include "ionskin/base/system/installation.hpp"
#include "ionskin/base/system/processes.hpp"
#include "ionskin/case/text/data_folder.hpp"
#include "verbs/cache.hpp"

#include <fmt/core.h>

#include <array>
#include <fcntl.h>
#include <filesystem>
#include <sys/sysinfo.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace ionskin::apps {
namespace {

namespace fs = std::filesystem;

enum class Finding { good, missing, note };

/// Prints one line for each check, and remembers whether anything needed is missing.
class Findings {
public:
  void add(Finding finding, const std::string& what, const std::string& remedy = "") {
    constexpr std::array words{"ok", "MISSING", "note"};
    fmt::print("{:<8} {}\n", words[static_cast<std::size_t>(finding)], what);
    if (finding != Finding::good && !remedy.empty()) {
      fmt::print("{:<8} = {}\n", "", remedy);
    }
    complete_ = complete_ && finding != Finding::missing;
  }
  void check(bool good, const std::string& what, const std::string& remedy) {
    add(good ? Finding::good : Finding::missing, what, remedy);
  }
  bool complete() const { return complete_; }

private:
  bool complete_ = true;
};

/// Runs a program without output; true if it ends with exit code 0.
bool runs(const std::vector<std::string>& words) {
  const base::FileDescriptor nowhere(::open("/dev/null", O_WRONLY | O_CLOEXEC));
  const pid_t child = base::start_program(words, {nowhere, nowhere});
  return child >= 0 && base::wait_for_end(child) == 0;
}

void check_processor(Findings& findings) {
  try {
    require_vector_instructions();
    findings.add(Finding::good, "processor has the vector instructions of this binary");
  } catch (const UserError& error) {
    findings.add(Finding::missing, "vector instructions", error.what());
  }
  struct sysinfo memory {};
  sysinfo(&memory);
  const double gigabytes = static_cast<double>(memory.totalram) * memory.mem_unit / 1e9;
  findings.add(Finding::good, fmt::format("{} threads", thread_count(0)));
  findings.add(gigabytes >= 1 ? Finding::good : Finding::note,
               fmt::format("{:.1f} GB of memory", gigabytes),
               "a finger at the standard preset needs about 0.5 GB: use the coarse preset");
}

void check_program(Findings& findings) {
  const fs::path& solver = base::installation().solver;
  findings.check(
      runs({solver.string(), "--version"}), "solver with its libraries: " + solver.string(),
      "install the package again; in a build tree build both programs, with the packages "
      "of packages.txt: make build");
  const fs::path data = data_folder();
  findings.check(fs::is_directory(data / "cases") && fs::is_directory(data / "materials"),
                 "cases and materials in " + data.string(),
                 "let the environment variable IONSKIN_DATA name the folder that holds them");
  const fs::path python = base::python_package();
  findings.check(fs::is_regular_file(python / "ionskin" / "report.py"),
                 "Python package that draws reports in " + python.string(),
                 "install the package again");
}

void check_python(Findings& findings) {
  const std::string python = base::python_interpreter();
  const bool there = runs({python, "-I", "-c", "import sys; sys.exit(sys.version_info < (3, 11))"});
  findings.check(there, "Python 3.11 or later for figures and reports: " + python,
                 "apt-get install python3");
  for (const char* module : {"numpy", "h5py", "matplotlib", "jinja2"}) {
    if (there) {
      findings.check(runs({python, "-I", "-c", std::string("import ") + module}),
                     std::string("Python module ") + module,
                     std::string("apt-get install python3-") + module);
    }
  }
}

/// Checks the Python modules that only some commands need.
void check_optional_modules(Findings& findings) {
  const std::string python = base::python_interpreter();
  constexpr std::array modules{
      std::pair{"openturns", "ionskin uncertainty, design and generate"},
      std::pair{"scipy", "ionskin uncertainty, design and generate"},
      std::pair{"distributed", "ionskin cluster and sweep --on"},
      std::pair{"xarray", "labelled arrays (Results.to_xarray)"},
  };
  for (const auto& [module, purpose] : modules) {
    const bool there = runs({python, "-I", "-c", std::string("import ") + module});
    findings.add(
        there ? Finding::good : Finding::note,
        fmt::format("Python module {}{}: for {}", module, there ? "" : " is not there", purpose),
        std::string("apt-get install python3-") + module);
  }
}

bool writable(const fs::path& folder) {
  return access(folder.c_str(), W_OK | X_OK) == 0;
}

void check_folders(Findings& findings) {
  std::error_code error;
  const fs::path here = fs::current_path(error);
  findings.check(!error && writable(here), "write access to this folder",
                 "change to a folder of yours, or give another with -o");
  const auto space = fs::space(here, error);
  const double gigabytes = error ? 0 : static_cast<double>(space.available) / 1e9;
  findings.add(gigabytes > 1 ? Finding::good : Finding::note,
               fmt::format("{:.1f} GB free here", gigabytes),
               "a sweep of ten points writes about 0.5 GB");
  findings.add(Finding::good, cache_summary());
}

} // namespace

int doctor() {
  Findings findings;
  check_processor(findings);
  check_program(findings);
  check_python(findings);
  check_optional_modules(findings);
  check_folders(findings);
  fmt::print("{}\n",
             findings.complete() ? "Nothing is missing." : "Something is missing: see above.");
  return static_cast<int>(findings.complete() ? ExitCode::success : ExitCode::user_error);
}

} // namespace ionskin::apps
