// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/data/field_data.hpp"
#include "studio/data/workspace.hpp"
#include "studio/jobs/job_queue.hpp"
#include "studio/server/access.hpp"

#include <httplib.h>

#include <atomic>
#include <functional>
#include <memory>
#include <string>

namespace ionskin::apps::studio {

/// Answers the page and its calls. Whatever a request is, the gate in `admit` is passed first:
/// host, origin, cookie, size of the body.
class Server {
public:
  /// @param port 0 for any that is free
  /// Throws UserError when the port is taken.
  Server(Workspace& workspace, JobQueue& jobs, int port);

  /// The link that opens the page once.
  std::string link() const;
  /// Serves until `stop`.
  void listen();
  /// May be called from another thread.
  void stop();

private:
  using Answer = std::function<void(const httplib::Request&, httplib::Response&)>;
  using Handled = httplib::Server::HandlerResponse;
  Handled admit(const httplib::Request& request, httplib::Response& response);
  void get(const std::string& path, Answer answer);
  void post(const std::string& path, Answer answer);
  void serve_case_calls();
  void serve_job_calls();
  void serve_result_calls();
  void serve_file_calls();
  void serve_events(const httplib::Request& request, httplib::Response& response);

  Workspace& workspace_;
  JobQueue& jobs_;
  FieldData fields_;
  int port_ = 0;
  std::unique_ptr<Access> access_;
  std::atomic<std::size_t> listeners_ = 0;
  httplib::Server http_;
};

/// Answers with content that is sent as it is, never compressed.
void send(httplib::Response& response, std::string content, const char* type);
void send_json(httplib::Response& response, const Json& value);

} // namespace ionskin::apps::studio
