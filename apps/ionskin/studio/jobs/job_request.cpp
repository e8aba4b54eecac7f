// SPDX-License-Identifier: Apache-2.0
#include "studio/jobs/job_request.hpp"

#include "ionskin/base/files/read_text_file.hpp"
#include "ionskin/case/schema/schema.hpp"
#include "studio/data/case_check.hpp"
#include "studio/jobs/job_words.hpp"
#include "studio/server/limits.hpp"
#include "terminal/terminal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

namespace ionskin::apps::studio {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_values = 1000; // of one swept key
constexpr std::size_t most_keys = 8;

/// Python literal of a text.
std::string python_text(const std::string& text) {
  return Json(text).dump(-1, ' ', true, Json::error_handler_t::replace);
}

bool is_number(const std::string& text) {
  double ignored = 0;
  const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const auto [end, status] = std::from_chars(begin, text.data() + text.size(), ignored);
  return status == std::errc() && end == text.data() + text.size();
}

/// Requires that a swept value holds no separator of --over and has a sensible length. Throws
/// HttpError 400.
void require_value(const std::string& text) {
  const auto bad = [](char c) {
    return c == ',' || c == ':' || static_cast<unsigned char>(c) < 32;
  };
  if (text.empty() || text.size() > 200 || std::any_of(text.begin(), text.end(), bad)) {
    throw HttpError(400, "a swept value is a number, a quantity or a word");
  }
}

std::string known_key(const std::string& key) {
  if (find_row(key_pattern(key)) == nullptr) {
    throw HttpError(400, fmt::format("{} is not a key of a case", key));
  }
  return key;
}

Json list_in(const Json& request, const char* name, std::size_t most) {
  const Json list = request.value(name, Json::array());
  if (!list.is_array() || list.empty() || list.size() > most) {
    throw HttpError(400, fmt::format("{} has 1 to {} entries", name, most));
  }
  return list;
}

/// True if `source` is a case file of the workspace that still has this text; the job then uses the
/// file, and needs no new one.
bool is_text_of(const Workspace& workspace, const std::string& source, const std::string& text) {
  if (source.empty()) {
    return false;
  }
  const Opened file = workspace.open(source);
  return base::read_text_file(file.file, file.name, "case", limits::body) == text;
}

void add_sweep(const Json& request, Job& job) {
  std::string over_python;
  for (const Json& axis : list_in(request, "over", most_keys)) {
    const std::string key = known_key(text_of(axis, "key"));
    std::string values, values_python;
    for (const Json& value : list_in(axis, "values", most_values)) {
      const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
      require_value(text);
      values += (values.empty() ? "" : ",") + text;
      values_python +=
          (values_python.empty() ? "" : ", ") + (is_number(text) ? text : python_text(text));
    }
    job.words.insert(job.words.end(), {"--over", key + "=" + values});
    over_python +=
        (over_python.empty() ? "" : ", ") + python_text(key) + ": [" + values_python + "]";
  }
  job.python +=
      fmt::format("result = ionskin.sweep(case, {{{}}}, {})", over_python, python_text(job.folder));
}

void add_fit(const Workspace& workspace, const Json& request, Job& job) {
  const Opened measured = workspace.open(text_of(request, "data"));
  if (!is_file(measured.file)) {
    throw HttpError(400, "data is the name of a CSV file in the workspace");
  }
  const std::string& data = measured.name;
  const std::string column = text_of(request, "column");
  std::string keys, keys_python;
  for (const Json& key : list_in(request, "free", most_keys)) {
    const std::string name = known_key(key.is_string() ? key.get<std::string>() : "");
    keys += (keys.empty() ? "" : ",") + name;
    keys_python += (keys_python.empty() ? "" : ", ") + python_text(name);
  }
  job.words.insert(job.words.end(), {"--data", data, "--free", keys});
  if (!column.empty()) {
    job.words.insert(job.words.end(), {"--column", column});
  }
  job.python +=
      fmt::format("result = ionskin.fit(case, {}, [{}], {}, column={})", python_text(data),
                  keys_python, python_text(job.folder), python_text(column));
}

Job report_job(const Workspace& workspace, const Json& request) {
  Job job;
  job.kind = "report";
  job.folder = workspace.open(text_of(request, "path")).name;
  job.words = {"report", job.folder};
  job.command = shell_text({"ionskin", "report", job.folder});
  job.python =
      fmt::format("import ionskin\nresult = ionskin.open_results({})", python_text(job.folder));
  return job;
}

/// Makes the job of a run, a sweep or a fit.
/// @param file name of the case file
/// @param folder name of the folder of the results
Job study_job(const Workspace& workspace, const Json& request, const std::string& file,
              const std::string& folder) {
  Job job;
  job.kind = text_of(request, "kind");
  job.folder = folder;
  job.words = {job.kind, file, "-o", job.folder};
  job.python =
      fmt::format("import ionskin\ncase = ionskin.Case.from_file({})\n", python_text(file));
  if (job.kind == "run") {
    job.python += fmt::format("result = ionskin.run(case, {})", python_text(job.folder));
  } else if (job.kind == "sweep") {
    add_sweep(request, job);
  } else {
    add_fit(workspace, request, job);
  }
  if (job.kind != "fit") {
    job.words.push_back("--no-report");
  }
  std::vector<std::string> shown{"ionskin"};
  shown.insert(shown.end(), job.words.begin(), job.words.end());
  job.command = shell_text(shown);
  job.words.insert(job.words.end(), {"--log", "json"});
  return job;
}

} // namespace

RequestedJob::RequestedJob(const Workspace& workspace, const Json& request) {
  const std::string kind = text_of(request, "kind");
  if (kind == "report") {
    job = report_job(workspace, request);
    require_inside(workspace, job.words);
    return;
  }
  if (kind != "run" && kind != "sweep" && kind != "fit") {
    throw HttpError(400, "a job is a run, a sweep, a fit or a report");
  }
  const std::string text = text_of(request, "case"), source = text_of(request, "source");
  const Json verdict = check_case(workspace, text);
  require_valid(verdict);
  const bool own_file = !is_text_of(workspace, source, text);
  std::string folder = free_name(workspace, text_of(request, "name", kind));
  if (!request.value("dry", false)) {
    results.emplace(workspace, text_of(request, "name", kind), own_file ? &text : nullptr);
    folder = results->name();
  }
  job = study_job(workspace, request, own_file ? folder + ".toml" : workspace.open(source).name,
                  folder);
  if (results) {
    require_inside(workspace, job.words);
  }
  if (const Json cost = verdict.value("cost", Json()); cost.is_object()) {
    job.memory = cost.value("memory_bytes", 0.0);
    job.seconds = cost.value("seconds", 0.0);
  }
}

} // namespace ionskin::apps::studio
