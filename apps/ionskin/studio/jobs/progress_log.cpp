// SPDX-License-Identifier: Apache-2.0
#include "studio/jobs/progress_log.hpp"

#include "ionskin/base/files/read_json.hpp"
#include "studio/server/limits.hpp"

#include <fstream>
#include <sstream>

namespace ionskin::apps::studio {
namespace {

std::string end_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) {
    return "";
  }
  const auto size = static_cast<std::size_t>(file.tellg());
  std::string text(std::min(size, limits::log_tail), '\0');
  file.seekg(static_cast<std::streamoff>(size - text.size()));
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

/// Reads the progress that a line reports; nullopt for any other line.
std::optional<base::Json> progress_in(const std::string& line) {
  const auto entry = line.starts_with('{') ? base::parse_json(line) : std::nullopt;
  const auto number = [&](const char* name) {
    return entry->contains(name) && entry->at(name).is_number();
  };
  const bool whole = entry && entry->is_object() && number("fraction") && number("elapsed_s") &&
                     entry->contains("activity") && entry->at("activity").is_string();
  return whole ? entry : std::nullopt;
}

} // namespace

ProgressLog read_progress(const std::filesystem::path& messages) {
  ProgressLog log;
  std::istringstream lines(end_of(messages));
  for (std::string line; std::getline(lines, line);) {
    const auto entry = progress_in(line);
    if (!entry) {
      if (!line.empty() && line.back() != '}') {
        log.messages += line + "\n";
      }
      continue;
    }
    log.activity = entry->at("activity").get<std::string>();
    log.fraction = entry->at("fraction").get<double>();
    const double elapsed = entry->at("elapsed_s").get<double>();
    log.left = log.fraction > 0.02 ? elapsed * (1 - log.fraction) / log.fraction : -1;
    if (const auto time_left = entry->find("time_left_s");
        time_left != entry->end() && time_left->is_number()) {
      log.left = time_left->get<double>();
    }
  }
  return log;
}

} // namespace ionskin::apps::studio
