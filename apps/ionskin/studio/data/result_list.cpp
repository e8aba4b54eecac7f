// SPDX-License-Identifier: Apache-2.0
#include "studio/data/result_list.hpp"

#include "ionskin/base/text.hpp"
#include "studio/jobs/job.hpp"
#include "studio/server/limits.hpp"

#include <algorithm>
#include <vector>

namespace ionskin::apps::studio {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t largest_text = 8u << 20;

/// What lies in the folder itself and is no link.
bool has(const fs::path& folder, const char* name) {
  std::error_code error;
  return fs::is_regular_file(fs::symlink_status(folder / name, error));
}

std::string text_in(const fs::path& folder, const char* name) {
  return has(folder, name) ? file_text(folder / name, largest_text) : "";
}

Json json_in(const fs::path& folder, const char* name) {
  Json value = Json::parse(text_in(folder, name), nullptr, false);
  return value.is_object() ? value : Json::object();
}

/// The title in a case's text, without reading the whole case.
std::string title_in(const std::string& text) {
  const std::size_t begin = text.rfind("title", 0) == 0 ? 0 : text.find("\ntitle");
  const std::size_t open = text.find('"', begin == std::string::npos ? text.size() : begin);
  const std::size_t end = text.find('\n', open);
  if (open == std::string::npos) {
    return "";
  }
  std::string rest = text.substr(open, end == std::string::npos ? end : end - open);
  rest = rest.substr(0, rest.rfind('"') + 1);
  const Json title = Json::parse(rest, nullptr, false); // escapes as in JSON
  return title.is_string() ? title.get<std::string>() : rest;
}

Json outline(const Workspace& workspace, const fs::path& folder, const std::string& kind) {
  const Json manifest = json_in(folder, "manifest.json");
  const Json summary = json_in(folder, kind == "fit" ? "fit.json" : "summary.json");
  Json one = {{"path", workspace.relative(folder)},
              {"kind", kind},
              {"title", title_in(text_in(folder, kind == "fit" ? "fitted.toml" : "case.toml"))},
              {"state", manifest.value("state", "")},
              {"started", manifest.value("started", "")},
              {"command", manifest.value("command", "")},
              {"warnings", summary.value("warnings", Json::array())},
              {"metrics", Json::object()}};
  const Json metrics = summary.value("metrics", Json::object());
  for (const char* name : {"normal_force_slide", "mean_shear_slide", "peak_sampled_current_top",
                           "peak_sampled_current_difference", "rms_current_difference"}) {
    if (metrics.contains(name)) {
      one["metrics"][name] = metrics[name];
    }
  }
  return one;
}

void look_into(const Workspace& workspace, const fs::path& folder, int depth, std::size_t& left,
               Json& list) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (left == 0) {
      return;
    }
    if (!fs::is_directory(entry.symlink_status(error)) ||
        entry.path().filename().string().front() == '.') {
      continue;
    }
    --left;
    const std::string kind = result_kind(entry.path());
    if (!kind.empty()) {
      list.push_back(outline(workspace, entry.path(), kind));
    } else if (depth > 1) {
      look_into(workspace, entry.path(), depth - 1, left, list);
    }
  }
}

Json table_names(const fs::path& folder) {
  Json names = Json::array();
  for (const std::string& name : known_tables()) {
    if (has(folder, (name + ".csv").c_str())) {
      names.push_back(name);
    }
  }
  return names;
}

/// Folders of a sweep's points in their order.
Json points(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder / "points", error)) {
    if (fs::is_directory(entry.symlink_status(error))) {
      names.push_back(entry.path().filename().string());
    }
  }
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

std::string result_kind(const fs::path& folder) {
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
  if (const std::string kind = result_kind(workspace.root()); !kind.empty()) {
    list.push_back(outline(workspace, workspace.root(), kind));
  } else {
    look_into(workspace, workspace.root(), limits::listed_depth, left, list);
  }
  std::sort(list.begin(), list.end(), [](const Json& a, const Json& b) {
    return a["started"].get<std::string>() > b["started"].get<std::string>();
  });
  return list;
}

Json describe_result(const Workspace& workspace, const fs::path& folder) {
  const std::string kind = result_kind(folder);
  if (kind.empty()) {
    throw HttpError(404, "this folder holds no results of ionskin");
  }
  Json one = outline(workspace, folder, kind);
  const Json summary = json_in(folder, kind == "fit" ? "fit.json" : "summary.json");
  one["summary"] = summary;
  one["manifest"] = json_in(folder, "manifest.json");
  one["case"] = text_in(folder, kind == "fit" ? "fitted.toml" : "case.toml");
  one["tables"] = table_names(folder);
  one["fields"] = has(folder, "results.h5");
  one["report"] = has(folder, "report.html");
  if (kind == "sweep") {
    one["points"] = points(folder);
  }
  return one;
}

} // namespace ionskin::apps::studio
