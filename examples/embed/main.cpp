// SPDX-License-Identifier: Apache-2.0

// Runs a case at several friction coefficients and prints a figure of each: the library instead of
// the program.

#include "ionskin/base/error.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/study/run/run_case.hpp"

#include <cstdio>
#include <filesystem>
#include <string>

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: embed CASE.toml DIR\n");
    return 2;
  }
  try {
    for (const std::string friction : {"0.1", "0.3"}) {
      const ionskin::Case input = ionskin::read_case(argv[1], {"contact.friction=" + friction});
      ionskin::study::RunOptions options;
      options.folder = std::filesystem::path(argv[2]) / ("friction_" + friction);
      options.threads = 2;
      options.report = false;
      options.command = "embed";
      const ionskin::study::RunOutcome outcome = ionskin::study::run_case(input, options);
      for (const ionskin::readout::Metric& metric : outcome.metrics) {
        if (metric.name == "tangential_force_slide") {
          std::printf("friction %s: %s = %.4g %s\n", friction.c_str(), metric.name.c_str(),
                      metric.value, metric.unit.c_str());
        }
      }
    }
  } catch (const ionskin::UserError& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 2;
  } catch (const ionskin::SolverError& error) {
    std::fprintf(stderr, "error: %s\nremedy: %s\n", error.what(), error.remedy().c_str());
    return 3;
  }
}
