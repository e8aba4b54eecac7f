// SPDX-License-Identifier: Apache-2.0
#include "studio/data/case_check.hpp"

#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/files/read_json.hpp"
#include "ionskin/case/schema/schema.hpp"
#include "studio/jobs/process.hpp"
#include "studio/server/limits.hpp"

#include <fmt/format.h>

#include <atomic>
#include <regex>
#include <semaphore>
#include <sstream>
#include <unistd.h>

namespace ionskin::apps::studio {

namespace fs = std::filesystem;

namespace {

std::counting_semaphore<limits::checks_at_once> checks{limits::checks_at_once};

/// Temporary file, which the destructor removes.
struct ScratchFile {
  fs::path path;
  ~ScratchFile() {
    std::error_code error;
    fs::remove(path, error);
  }
};

/// Keys of the schema that a message names, as a JSON array.
Json keys_in(const std::string& message) {
  static const std::regex word(
      R"(\b[A-Za-z_][\w-]*(\[\d+\])?(\.[A-Za-z_][\w-]*(\[\d+\])?)+|\btitle\b)");
  Json keys = Json::array();
  for (std::sregex_iterator match(message.begin(), message.end(), word), end; match != end;
       ++match) {
    const std::string key = match->str();
    if (find_row(key_pattern(key)) != nullptr) {
      keys.push_back(key);
    }
  }
  return keys;
}

Json one_error(const std::string& text) {
  std::string message, remedy;
  Json line, column, length;
  static const std::regex numbered(R"(^ *(\d+) \|.*)"), marks(R"(^ *\| ( *)(\^+).*)");
  bool in_excerpt = false;
  std::istringstream lines(text);
  for (std::string row; std::getline(lines, row);) {
    std::smatch match;
    if (row.find("--> ") < 8) {
      in_excerpt = true;
    } else if (row.rfind("  = ", 0) == 0) {
      remedy += (remedy.empty() ? "" : "\n") + row.substr(4);
    } else if (in_excerpt && line.is_null() && std::regex_match(row, match, numbered)) {
      line = std::stol(match[1].str().substr(0, 9));
    } else if (in_excerpt && column.is_null() && std::regex_match(row, match, marks)) {
      column = match[1].length() + 1;
      length = match[2].length();
    } else if (!in_excerpt) {
      message += (message.empty() ? "" : "\n") + row;
    }
  }
  while (!message.empty() && message.back() == '\n') {
    message.pop_back();
  }
  return {{"message", message}, {"remedy", remedy}, {"line", line},
          {"column", column},   {"length", length}, {"keys", keys_in(message)}};
}

/// Errors, as of `check_case`, for the files that a valid case names outside the workspace.
Json files_outside(const Workspace& workspace, const Json& values) {
  Json errors = Json::array();
  for (const Json& value : values) {
    const std::string key = value.value("key", "");
    const std::string name = value.value("text", "");
    if (!names_file(key) || name.empty()) {
      continue;
    }
    try {
      workspace.open(name);
    } catch (const HttpError&) {
      errors.push_back({{"message", key + " names a file outside the workspace"},
                        {"remedy", "copy the file into the workspace and name it without a folder"},
                        {"line", value.value("line", Json())},
                        {"column", nullptr},
                        {"length", nullptr},
                        {"keys", {key}}});
    }
  }
  return errors;
}

Json failure(const std::string& message) {
  return {{"valid", false}, {"errors", split_errors(message)}};
}

} // namespace

bool names_file(const std::string& key) {
  const std::string pattern = key_pattern(key); // that of a single slider for each of a list
  return pattern == "strain.file" || pattern == "slider.profile" || pattern == "motion.file";
}

void require_valid(const Json& verdict) {
  if (!verdict.value("valid", false)) {
    throw HttpError(422, "the case has mistakes: " +
                             verdict["errors"][0].value("message", std::string("see its check")));
  }
}

Json split_errors(const std::string& text) {
  std::string rest = text.rfind("error: ", 0) == 0 ? text.substr(7) : text;
  Json errors = Json::array();
  static const std::regex heading(R"(^\((\d+)\) )", std::regex::multiline);
  std::sregex_iterator match(rest.begin(), rest.end(), heading), end;
  if (match == end) {
    errors.push_back(one_error(rest));
  }
  while (match != end) {
    const auto begin = static_cast<std::size_t>(match->position() + match->length());
    ++match;
    const auto stop = match == end ? rest.size() : static_cast<std::size_t>(match->position());
    errors.push_back(one_error(rest.substr(begin, stop - begin)));
  }
  return errors;
}

Json check_case(const Workspace& workspace, const std::string& text) {
  static std::atomic<unsigned> number = 0;
  checks.acquire();
  struct Release {
    ~Release() { checks.release(); }
  } release;
  // In the workspace, for files that a case names lie beside it. Others may have a Studio here,
  // too.
  const ScratchFile scratch{workspace.root() /
                            fmt::format(".studio-check-{}-{}.toml", ::getpid(), ++number)};
  base::write_text_file(scratch.path, text);
  Outcome outcome =
      run_to_end({program().string(), "check", scratch.path.filename().string(), "--json"},
                 workspace.folder(), limits::check_time, limits::check_memory);
  if (outcome.timed_out) {
    return failure("the check takes too long: the case is too large to be estimated");
  }
  if (outcome.exit_code != 0) {
    outcome.rename(scratch.path.filename().string(), "the case");
    return failure(outcome.errors.empty() ? "the check ended early: the case needs too much memory"
                                          : outcome.errors);
  }
  const auto verdict = base::parse_json(outcome.output);
  if (!verdict || !verdict->is_object()) {
    return failure("the check's answer cannot be read");
  }
  const Json outside = files_outside(workspace, verdict->value("values", Json::array()));
  return outside.empty() ? *verdict : Json{{"valid", false}, {"errors", outside}};
}

} // namespace ionskin::apps::studio
