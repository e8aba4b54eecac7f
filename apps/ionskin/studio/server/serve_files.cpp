// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/files/read_text_file.hpp"
#include "studio/data/new_names.hpp"
#include "studio/server/limits.hpp"
#include "studio/server/server.hpp"

#include <algorithm>

namespace ionskin::apps::studio {

namespace fs = std::filesystem;

namespace {

bool is_text(const fs::path& path) {
  return path.extension() == ".toml" || path.extension() == ".csv" || path.extension() == ".json";
}

/// Lists the case files and CSV files in the workspace folder itself, {"cases", "data"}.
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

/// Reads an ordinary file that a request names. Throws HttpError 404 for anything but a file.
/// @param most largest size [bytes]
std::string file_text(const Workspace& workspace, const std::string& path, std::size_t most) {
  const Opened opened = workspace.open(path);
  if (!is_file(opened.file)) {
    throw HttpError(404, "this is not a file but a folder, a pipe or a device");
  }
  return base::read_text_file(opened.file, opened.name, "chosen", most);
}

} // namespace

/// Adds the calls on files of the workspace: list, text, download, upload.
void Server::serve_file_calls() {
  get("/api/files", [this](const Request&, Response& response) {
    Json all = list_files(workspace_);
    all["workspace"] = workspace_.root().filename().string();
    send_json(response, all);
  });
  get("/api/text", [this](const Request& request, Response& response) {
    const std::string path = request.parameter("path");
    const std::string text = file_text(workspace_, path, limits::upload);
    if (!is_text(path)) {
      throw HttpError(404, "only cases, tables and summaries are shown as text");
    }
    send_json(response, {{"text", text}});
  });
  get("/api/download", [this](const Request& request, Response& response) {
    std::string text = file_text(workspace_, request.parameter("path"), limits::table_bytes);
    // Never shown by the browser as a page of the Studio.
    response.headers.emplace_back("Content-Disposition", "attachment");
    send(response, std::move(text), "application/octet-stream");
  });
  post("/api/upload", [this](const Request& request, Response& response) {
    const fs::path name = request.parameter("name");
    if (name.extension() != ".csv") {
      throw HttpError(400, "a measurement is a file NAME.csv");
    }
    const std::string path =
        write_new_file(workspace_, name.parent_path() / name.stem(), ".csv", request.body);
    response.status = 201;
    send_json(response, {{"path", path}});
  });
}

} // namespace ionskin::apps::studio
