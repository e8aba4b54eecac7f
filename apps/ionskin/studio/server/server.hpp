// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/data/field_data.hpp"
#include "studio/data/workspace.hpp"
#include "studio/http/gate.hpp"
#include "studio/jobs/job_queue.hpp"
#include "studio/server/access.hpp"
#include "studio/server/json.hpp"
#include "studio/server/link_file.hpp"

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace ionskin::apps::studio {

/// Answers the page and its calls. Whatever a request is, `admit` is passed first: host, origin,
/// cookie, size of the body.
class Server {
public:
  /// @param port 0 for any that is free
  /// Throws UserError when the port is taken.
  Server(Workspace& workspace, JobQueue& jobs, int port);

  /// The link that opens the page once.
  std::string link() const;
  /// A page that only the user can read and that leads to the link; it is there until the link is
  /// used or the server ends. Called before `listen`. Throws std::system_error.
  std::filesystem::path link_file();
  /// Serves until `stop`.
  void listen();
  /// May be called from another thread.
  void stop();

private:
  using Answer = std::function<void(const Request&, Response&)>;
  std::size_t admit(const Request& head) const;
  Response answer(Request& request);
  void route(Request& request, Response& response);
  void open(const Request& request, Response& response);
  void get(const std::string& path, Answer answer);
  void post(const std::string& path, Answer answer);
  void serve_case_calls();
  void serve_job_calls();
  void serve_result_calls();
  void serve_file_calls();
  void serve_events(Response& response);

  Workspace& workspace_;
  JobQueue& jobs_;
  FieldData fields_;
  Gate gate_;
  Access access_;
  std::optional<LinkFile> link_file_;
  std::map<std::string, std::map<std::string, Answer>> calls_; ///< by path, by method
  std::atomic<std::size_t> listeners_ = 0;
};

/// Answers with content of a type.
void send(Response& response, std::string content, const char* type);
void send_json(Response& response, const Json& value);

} // namespace ionskin::apps::studio
