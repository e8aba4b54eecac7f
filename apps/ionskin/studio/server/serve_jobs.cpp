// SPDX-License-Identifier: Apache-2.0
#include "studio/jobs/found_jobs.hpp"
#include "studio/jobs/job_request.hpp"
#include "studio/server/limits.hpp"
#include "studio/server/server.hpp"

#include <fmt/format.h>

namespace ionskin::apps::studio {

/// Adds the calls on jobs: start, follow, cancel, resume, remove.
void Server::serve_job_calls() {
  get("/api/jobs",
      [this](const Request&, Response& response) { send_json(response, jobs_.list()); });
  post("/api/jobs", [this](const Request& request, Response& response) {
    const Json body = parse_object(request.body);
    RequestedJob asked(workspace_, body);
    const Job& job = asked.job;
    const Json answer = {{"folder", job.folder}, {"command", job.command}, {"python", job.python}};
    if (body.value("dry", false)) {
      send_json(response, answer);
      return;
    }
    Json all = answer;
    all["id"] = jobs_.add(job);
    if (asked.results) {
      asked.results->keep();
    }
    response.status = 201;
    send_json(response, all);
  });
  post("/api/jobs/ID/cancel", [this](const Request& request, Response& response) {
    jobs_.cancel(request.id);
    send_json(response, Json::object());
  });
  post("/api/jobs/ID/resume", [this](const Request& request, Response& response) {
    require_runnable(workspace_, jobs_.job(request.id));
    jobs_.resume(request.id);
    send_json(response, Json::object());
  });
  post("/api/jobs/ID/remove", [this](const Request& request, Response& response) {
    jobs_.remove(request.id);
    send_json(response, Json::object());
  });
  get("/api/events", [this](const Request&, Response& response) { serve_events(response); });
}

/// Streams the list of jobs as server-sent events, whenever it changes.
void Server::serve_events(Response& response) {
  if (++listeners_ > limits::listeners) {
    --listeners_;
    throw HttpError(429, "too many pages follow the progress; close some");
  }
  const std::shared_ptr<void> place(nullptr, [this](void*) { --listeners_; });
  response.type = "text/event-stream";
  response.stream = [this, place](const Response::Write& write) {
    std::uint64_t sent = 0;
    for (bool goes_on = true; goes_on;) {
      goes_on = jobs_.wait(sent, std::chrono::seconds(10));
      const std::uint64_t version = jobs_.version();
      const std::string event = version == sent
                                    ? std::string(": still here\n\n")
                                    : fmt::format("event: jobs\ndata: {}\n\n", dump(jobs_.list()));
      sent = version;
      goes_on = write(event) && goes_on;
    }
  };
}

} // namespace ionskin::apps::studio
