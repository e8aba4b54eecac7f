// SPDX-License-Identifier: Apache-2.0
#include "studio/data/result_list.hpp"
#include "studio/data/table_data.hpp"
#include "studio/jobs/process.hpp"
#include "studio/server/limits.hpp"
#include "studio/server/server.hpp"

#include <algorithm>

namespace ionskin::apps::studio {
namespace {

constexpr const char* numbers = "application/octet-stream";

/// A file of a run that is no link out of its folder.
std::filesystem::path file_of(const Workspace& workspace, const Request& request,
                              const std::string& name) {
  return workspace.inside(request.parameter("path") + "/" + name);
}

std::string compare(const Workspace& workspace, const Request& request) {
  const auto first = workspace.relative(workspace.inside(request.parameter("first")));
  const auto second = workspace.relative(workspace.inside(request.parameter("second")));
  const Outcome outcome = run_to_end({program().string(), "compare", first, second},
                                     workspace.root(), limits::compare_time, 0);
  if (outcome.exit_code != 0) {
    throw HttpError(422, outcome.errors.empty() ? "the comparison ended early" : outcome.errors);
  }
  return outcome.output;
}

} // namespace

/// Results: the list, what a folder holds, tables and fields, differences.
void Server::serve_result_calls() {
  get("/api/runs", [this](const Request&, Response& response) {
    send_json(response, list_results(workspace_));
  });
  get("/api/result", [this](const Request& request, Response& response) {
    send_json(response, describe_result(workspace_, workspace_.inside(request.parameter("path"))));
  });
  get("/api/table", [this](const Request& request, Response& response) {
    const std::string name = request.parameter("name");
    if (std::ranges::find(known_tables(), name) == known_tables().end()) {
      throw HttpError(404, "there is no such table");
    }
    send(response, packed_table(file_of(workspace_, request, name + ".csv")), numbers);
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
