// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/files/atomic_file.hpp"
#include "studio/jobs/job.hpp"
#include "studio/server/limits.hpp"
#include "studio/server/server.hpp"

#include <algorithm>

namespace ionskin::apps::studio {

namespace fs = std::filesystem;

namespace {

bool is_text(const fs::path& path) {
  return path.extension() == ".toml" || path.extension() == ".csv" || path.extension() == ".json";
}

/// Cases and measurements that lie in the workspace itself.
Json list_files(const Workspace& workspace) {
  std::vector<std::string> cases, data;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(workspace.root(), error)) {
    const fs::path& path = entry.path();
    if (!fs::is_regular_file(entry.symlink_status(error)) ||
        path.filename().string().front() == '.') {
      continue;
    }
    if (path.extension() == ".toml") {
      cases.push_back(path.filename().string());
    } else if (path.extension() == ".csv") {
      data.push_back(path.filename().string());
    }
  }
  std::sort(cases.begin(), cases.end());
  std::sort(data.begin(), data.end());
  return {{"cases", cases}, {"data", data}};
}

fs::path unused_place(const Workspace& workspace, const std::string& name) {
  fs::path path = workspace.place(name);
  if (path.extension() != ".csv") {
    throw HttpError(400, "a measurement is a file NAME.csv");
  }
  const std::string stem = path.stem().string();
  std::error_code error;
  for (int number = 2; fs::exists(fs::symlink_status(path, error)); ++number) {
    path = workspace.place(stem + "-" + std::to_string(number) + ".csv");
  }
  return path;
}

} // namespace

/// Files of the workspace: cases and measurements, and what a run wrote, to save.
void Server::serve_file_calls() {
  get("/api/files", [this](const Request&, Response& response) {
    Json all = list_files(workspace_);
    all["workspace"] = workspace_.root().filename().string();
    send_json(response, all);
  });
  get("/api/text", [this](const Request& request, Response& response) {
    const fs::path path = workspace_.inside(request.parameter("path"));
    std::error_code error;
    if (!is_text(path) || !fs::is_regular_file(path, error)) {
      throw HttpError(404, "only cases, tables and summaries are shown as text");
    }
    if (fs::file_size(path, error) > limits::upload) {
      throw HttpError(413, "this file is too large to be shown");
    }
    send_json(response, {{"text", file_text(path, limits::upload)}});
  });
  get("/api/download", [this](const Request& request, Response& response) {
    const fs::path path = workspace_.inside(request.parameter("path"));
    std::error_code error;
    if (!fs::is_regular_file(path, error) || fs::file_size(path, error) > limits::table_bytes) {
      throw HttpError(404, "there is no such file, or it is too large");
    }
    // Never shown by the browser as a page of the Studio.
    response.headers.emplace_back("Content-Disposition", "attachment");
    send(response, file_text(path, limits::table_bytes), "application/octet-stream");
  });
  post("/api/upload", [this](const Request& request, Response& response) {
    const fs::path path = unused_place(workspace_, request.parameter("name"));
    base::write_text_file(path, request.body);
    response.status = 201;
    send_json(response, {{"path", workspace_.relative(path)}});
  });
}

} // namespace ionskin::apps::studio
