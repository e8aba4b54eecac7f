// SPDX-License-Identifier: Apache-2.0
#include "studio/data/result_list.hpp"
#include "studio/data/table_data.hpp"
#include "studio/jobs/process.hpp"
#include "studio/server/limits.hpp"
#include "studio/server/server.hpp"

#include <algorithm>
#include <filesystem>

namespace ionskin::apps::studio {

namespace fs = std::filesystem;

namespace {

constexpr const char* numbers = "application/octet-stream";

/// Opens a file in the folder of results that a request names.
Opened file_of(const Workspace& workspace, const Request& request, const std::string& name) {
  Opened opened = workspace.open(request.parameter("path") + "/" + name);
  if (!is_file(opened.file)) {
    throw HttpError(404, opened.name + " is not an ordinary file");
  }
  return opened;
}

/// Opens a folder of results and requires that no link in it would lead another program out of the
/// workspace.
Opened plain_folder(const Workspace& workspace, const std::string& path) {
  Opened opened = workspace.open(path);
  std::error_code error;
  for (fs::directory_iterator at(path_of(opened.file), error), end; !error && at != end;
       at.increment(error)) {
    if (fs::is_symlink(at->symlink_status(error))) {
      throw HttpError(403, opened.name + " holds a link, and the Studio follows none");
    }
  }
  return opened;
}

std::string compare(const Workspace& workspace, const Request& request) {
  const Opened first = plain_folder(workspace, request.parameter("first"));
  const Opened second = plain_folder(workspace, request.parameter("second"));
  const Outcome outcome = run_to_end({program().string(), "compare", first.name, second.name},
                                     workspace.folder(), limits::compare_time, 0);
  if (outcome.exit_code != 0) {
    throw HttpError(422, outcome.errors.empty() ? "the comparison ended early" : outcome.errors);
  }
  return outcome.output;
}

} // namespace

/// Adds the calls on results: list, contents of a folder, tables and fields, differences of two
/// runs.
void Server::serve_result_calls() {
  // Pages name an empty icon; a browser may ask before it has read them.
  get("/favicon.ico", [](const Request&, Response& response) { response.status = 204; });
  get("/api/runs", [this](const Request&, Response& response) {
    send_json(response, list_results(workspace_));
  });
  get("/api/result", [this](const Request& request, Response& response) {
    send_json(response, describe_result(workspace_.open(request.parameter("path"))));
  });
  get("/api/table", [this](const Request& request, Response& response) {
    const std::string name = request.parameter("name");
    if (std::ranges::find(known_tables(), name) == known_tables().end()) {
      throw HttpError(404, "there is no such table");
    }
    const Opened table = file_of(workspace_, request, name + ".csv");
    send(response, packed_table(path_of(table.file)), numbers);
  });
  get("/api/fields", [this](const Request& request, Response& response) {
    send_json(response, fields_.list(file_of(workspace_, request, "results.h5")));
  });
  get("/api/field", [this](const Request& request, Response& response) {
    send(response,
         fields_.packed(file_of(workspace_, request, "results.h5"), request.parameter("group"),
                        request.parameter("frame"), request.parameter("name")),
         numbers);
  });
  get("/api/compare", [this](const Request& request, Response& response) {
    send_json(response, {{"text", compare(workspace_, request)}});
  });
}

} // namespace ionskin::apps::studio
