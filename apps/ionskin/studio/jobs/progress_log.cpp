// SPDX-License-Identifier: Apache-2.0
#include "studio/jobs/progress_log.hpp"

#include <sstream>

namespace ionskin::apps::studio {

ProgressLog read_progress(const std::string& text) {
  ProgressLog log;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const Json entry = line.rfind('{', 0) == 0 ? Json::parse(line, nullptr, false) : Json();
    if (!entry.is_object() || !entry.contains("activity") || !entry.contains("fraction")) {
      if (!line.empty() && line.back() != '}') {
        log.messages += line + "\n";
      }
      continue;
    }
    log.activity = entry.value("activity", "");
    log.fraction = entry.value("fraction", 0.0);
    const double elapsed = entry.value("elapsed_s", 0.0);
    log.left = log.fraction > 0.02 ? elapsed * (1 - log.fraction) / log.fraction : -1;
    if (const auto told = entry.find("time_left_s"); told != entry.end() && told->is_number()) {
      log.left = told->get<double>();
    }
  }
  return log;
}

} // namespace ionskin::apps::studio
