// SPDX-License-Identifier: Apache-2.0
#include "studio/jobs/job_words.hpp"

#include "ionskin/base/text.hpp"
#include "studio/data/case_check.hpp"
#include "studio/server/http_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace ionskin::apps::studio {
namespace {

constexpr std::array kinds{"run", "sweep", "fit", "report"};

[[noreturn]] void refuse(const std::string& word) {
  throw HttpError(
      422, fmt::format("the Studio runs no command with the argument {}", base::shown(word)));
}

/// Requires that a name is that of a folder for results in the workspace; it may not exist yet.
/// Throws HttpError.
void require_results(const Workspace& workspace, const std::string& name) {
  workspace.place(name);
  try {
    if (!is_folder(workspace.open(name).file)) {
      throw HttpError(422, name + " is a file, not a folder for results");
    }
  } catch (const HttpError& error) {
    if (error.status() != 404) {
      throw;
    }
  }
}

/// Requires that the value "key=value,value" of --over names only files of the workspace, where the
/// values of the key are names of files. Throws HttpError.
void require_swept(const Workspace& workspace, const std::string& word) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos) {
    refuse(word);
  }
  if (names_file(word.substr(0, equals))) {
    for (const std::string& value : base::split(word.substr(equals + 1), ',', " \t\"'")) {
      if (value.find('\\') != std::string::npos) {
        refuse(word);
      }
      workspace.open(value);
    }
  }
}

/// Requires that an option is known and that its value names nothing outside the workspace. Keys
/// and columns name no files. Throws HttpError.
void require_option(const Workspace& workspace, const std::string& option,
                    const std::string& value) {
  if (option == "-o") {
    require_results(workspace, value);
  } else if (option == "--data") {
    workspace.open(value);
  } else if (option == "--over") {
    require_swept(workspace, value);
  } else if (option != "--free" && option != "--column" &&
             !(option == "--log" && value == "json")) {
    refuse(option);
  }
}

} // namespace

JobWords require_inside(const Workspace& workspace, const std::vector<std::string>& words) {
  if (words.size() < 2 || std::ranges::find(kinds, words[0]) == kinds.end()) {
    refuse(words.empty() ? "" : words[0]);
  }
  if (words[1].starts_with('-')) {
    refuse(words[1]);
  }
  JobWords named{words[0], words[1], words[1]};
  workspace.open(named.subject);
  for (std::size_t i = 2; i < words.size(); ++i) {
    if (words[i] == "--no-report" || words[i] == "--resume") {
      continue;
    }
    if (i + 1 == words.size() || words[i + 1].starts_with('-')) {
      refuse(words[i]);
    }
    require_option(workspace, words[i], words[i + 1]);
    if (words[i] == "-o") {
      named.folder = words[i + 1];
    }
    ++i;
  }
  if (named.kind != "report" && named.folder == named.subject) {
    refuse(named.kind);
  }
  return named;
}

} // namespace ionskin::apps::studio
