// SPDX-License-Identifier: Apache-2.0
#include "studio/data/result_list.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/files/read_json.hpp"
#include "ionskin/base/files/read_text_file.hpp"
#include "studio/data/result_shape.hpp"
#include "studio/server/limits.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

namespace ionskin::apps::studio {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t largest_text = 8u << 20;

using base::FileDescriptor;

/// True if the folder has a file of the name that is not a link.
bool has(const FileDescriptor& folder, const std::string& name) {
  return is_file(open_below(folder, name));
}

/// Reads a text file of the folder. Throws UserError when it is too large.
std::string text_in(const FileDescriptor& folder, const char* name) {
  const FileDescriptor file = open_below(folder, name);
  return is_file(file) ? base::read_text_file(file, name, "result", largest_text) : "";
}

/// Reads a JSON file of the folder; an empty object when the file is missing. Throws UserError when
/// it is too large or not JSON.
Json json_in(const FileDescriptor& folder, const char* name) {
  const FileDescriptor file = open_below(folder, name);
  if (!is_file(file)) {
    return Json::object();
  }
  auto value = base::read_json(file, name, "result", largest_text);
  if (!value || !value->is_object()) {
    throw UserError(std::string(name) + " is damaged: it holds no JSON object");
  }
  return std::move(*value);
}

const char* summary_of(const std::string& kind) {
  return kind == "fit" ? "fit.json" : "summary.json";
}

const char* case_of(const std::string& kind) {
  return kind == "fit" ? "fitted.toml" : "case.toml";
}

/// Finds the title in the text of a case, without reading the case as a whole.
std::string title_in(const std::string& text) {
  const std::size_t begin = text.rfind("title", 0) == 0 ? 0 : text.find("\ntitle");
  const std::size_t open = text.find('"', begin == std::string::npos ? text.size() : begin);
  const std::size_t end = text.find('\n', open);
  if (open == std::string::npos) {
    return "";
  }
  std::string rest = text.substr(open, end == std::string::npos ? end : end - open);
  rest = rest.substr(0, rest.rfind('"') + 1);
  const auto title = base::parse_json(rest); // escapes as in JSON
  return title && title->is_string() ? title->get<std::string>() : rest;
}

/// Contents of a folder of results that a page shows. The files may come from anybody.
struct Contents {
  Json manifest = Json::object(), summary = Json::object();
  std::string case_text;
  std::string damage; ///< reason why the contents are not shown; empty when they are
};

Contents read_contents(const FileDescriptor& folder, const std::string& kind) {
  try {
    Contents contents{json_in(folder, "manifest.json"), json_in(folder, summary_of(kind)),
                      text_in(folder, case_of(kind)), ""};
    require_manifest(contents.manifest);
    require_summary(contents.summary);
    return contents;
  } catch (const UserError& error) {
    return {Json::object(), Json::object(), "", error.what()};
  }
}

/// Returns a command that pages offer for copying into a shell, if it consists of words as
/// `shell_text` writes them, and holds nothing that a shell would interpret; else an empty text.
std::string plain_command(const std::string& text) {
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (static_cast<unsigned char>(c) < 32 || c == 127) {
      return "";
    }
    if (c == '\'') {
      quoted = !quoted;
    } else if (!quoted && text.compare(i, 2, "\\'") == 0) {
      ++i;
    } else if (!quoted && std::isalnum(static_cast<unsigned char>(c)) == 0 &&
               std::string_view("_-./=,:+ ").find(c) == std::string_view::npos) {
      return "";
    }
  }
  return text.starts_with("ionskin ") && !quoted ? text : "";
}

Json outline(const Opened& folder, const std::string& kind, const Contents& contents) {
  const auto& [manifest, summary, case_text, damage] = contents;
  Json one = {{"path", folder.name},
              {"kind", kind},
              {"title", title_in(case_text)},
              {"state", damage.empty() ? manifest.value("state", "") : "damaged"},
              {"started", manifest.value("started", "")},
              {"command", plain_command(manifest.value("command", ""))},
              {"warnings", summary.value("warnings", Json::array())},
              {"metrics", Json::object()}};
  if (!damage.empty()) {
    one["warnings"].push_back(damage);
  }
  const Json metrics = summary.value("metrics", Json::object());
  for (const char* name : {"normal_force_slide", "mean_shear_slide", "peak_sampled_current_top",
                           "peak_sampled_current_difference", "rms_current_difference"}) {
    if (metrics.contains(name)) {
      one["metrics"][name] = metrics[name];
    }
  }
  return one;
}

/// Names of the folders in a folder; links are left out.
std::vector<std::string> folders_in(const FileDescriptor& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(path_of(folder), error), end; !error && at != end;
       at.increment(error)) {
    if (fs::is_directory(at->symlink_status(error))) {
      names.push_back(at->path().filename().string());
    }
  }
  return names;
}

void look_into(const Opened& folder, int depth, std::size_t& left, Json& list) {
  for (const std::string& name : folders_in(folder.file)) {
    if (left == 0) {
      return;
    }
    if (name.front() == '.') {
      continue;
    }
    --left;
    const Opened inner{open_below(folder.file, name), name_below(folder.name, name)};
    const std::string kind = result_kind(inner.file);
    if (!kind.empty()) {
      list.push_back(outline(inner, kind, read_contents(inner.file, kind)));
    } else if (depth > 1) {
      look_into(inner, depth - 1, left, list);
    }
  }
}

Json table_names(const FileDescriptor& folder) {
  Json names = Json::array();
  for (const std::string& name : known_tables()) {
    if (has(folder, name + ".csv")) {
      names.push_back(name);
    }
  }
  return names;
}

/// JSON array of the folders of a sweep's points, in order.
Json points(const FileDescriptor& folder) {
  std::vector<std::string> names = folders_in(open_below(folder, "points"));
  std::sort(names.begin(), names.end());
  return names;
}

} // namespace

const std::vector<std::string>& known_tables() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const char* name : {"signals", "sampled", "taxels", "sampled_taxels", "circuit",
                             "sampled_circuit", "water"}) {
      all.push_back(name);
      all.push_back(std::string(name) + "_error");
    }
    all.insert(all.end(), {"fit", "sweep"});
    return all;
  }();
  return names;
}

std::string result_kind(const FileDescriptor& folder) {
  if (has(folder, "sweep.csv")) {
    return "sweep";
  }
  if (has(folder, "fit.json")) {
    return "fit";
  }
  return has(folder, "manifest.json") && has(folder, "case.toml") ? "run" : "";
}

Json list_results(const Workspace& workspace) {
  Json list = Json::array();
  std::size_t left = limits::listed_folders;
  const Opened root = workspace.open(".");
  if (const std::string kind = result_kind(root.file); !kind.empty()) {
    list.push_back(outline(root, kind, read_contents(root.file, kind)));
  } else {
    look_into(root, limits::listed_depth, left, list);
  }
  std::sort(list.begin(), list.end(), [](const Json& a, const Json& b) {
    return a["started"].get<std::string>() > b["started"].get<std::string>();
  });
  return list;
}

Json describe_result(const Opened& folder) {
  const std::string kind = result_kind(folder.file);
  if (kind.empty()) {
    throw HttpError(404, "this folder holds no results of ionskin");
  }
  const Contents contents = read_contents(folder.file, kind);
  Json one = outline(folder, kind, contents);
  one["summary"] = contents.summary;
  one["manifest"] = contents.manifest;
  one["case"] = contents.case_text;
  one["tables"] = table_names(folder.file);
  one["fields"] = has(folder.file, "results.h5");
  one["report"] = has(folder.file, "report.html");
  if (kind == "sweep") {
    one["points"] = points(folder.file);
  }
  return one;
}

} // namespace ionskin::apps::studio
