// SPDX-License-Identifier: Apache-2.0
#include "studio/jobs/job_request.hpp"
#include "studio/server/limits.hpp"
#include "studio/server/server.hpp"

#include <fmt/format.h>

namespace ionskin::apps::studio {

/// Jobs: start, follow, cancel, resume.
void Server::serve_job_calls() {
  get("/api/jobs", [this](const httplib::Request&, httplib::Response& response) {
    send_json(response, jobs_.list());
  });
  post("/api/jobs", [this](const httplib::Request& request, httplib::Response& response) {
    const Json body = parse_object(request.body);
    Job job = job_of(workspace_, body);
    const Json answer = {{"folder", job.folder}, {"command", job.command}, {"python", job.python}};
    if (body.value("dry", false)) {
      send_json(response, answer);
      return;
    }
    Json all = answer;
    all["id"] = jobs_.add(std::move(job));
    response.status = 201;
    send_json(response, all);
  });
  post(R"(/api/jobs/(\d{1,20})/(cancel|resume))",
       [this](const httplib::Request& request, httplib::Response& response) {
         if (request.matches[2] == "cancel") {
           jobs_.cancel(request.matches[1]);
         } else {
           jobs_.resume(request.matches[1]);
         }
         send_json(response, Json::object());
       });
  get("/api/events", [this](const httplib::Request& request, httplib::Response& response) {
    serve_events(request, response);
  });
}

/// Server-sent events: the list of jobs whenever it changes.
void Server::serve_events(const httplib::Request&, httplib::Response& response) {
  if (++listeners_ > limits::listeners) {
    --listeners_;
    throw HttpError(429, "too many pages follow the progress; close some");
  }
  const auto told = std::make_shared<std::uint64_t>(0);
  response.set_chunked_content_provider(
      "text/event-stream",
      [this, told](std::size_t, httplib::DataSink& sink) {
        const bool goes_on = jobs_.wait(*told, std::chrono::seconds(10));
        const std::uint64_t version = jobs_.version();
        const std::string event =
            version == *told ? std::string(": still here\n\n")
                             : fmt::format("event: jobs\ndata: {}\n\n", dump(jobs_.list()));
        *told = version;
        if (!goes_on || !sink.write(event.data(), event.size())) {
          sink.done();
          return false;
        }
        return true;
      },
      [this](bool) { --listeners_; });
}

} // namespace ionskin::apps::studio
