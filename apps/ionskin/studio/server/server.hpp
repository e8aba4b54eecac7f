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

/// Server of the Studio: answers requests for the page and its calls. Every request must first pass
/// `admit`, which checks host, origin, cookie and the size of the body.
class Server {
public:
  /// Opens the port.
  /// @param workspace and jobs must outlive the server
  /// @param port TCP port of 127.0.0.1; 0 for any free port
  /// Throws UserError when the port is taken.
  Server(Workspace& workspace, JobQueue& jobs, int port);

  /// URL of the one-time link that opens the page.
  std::string link() const;
  /// Writes an HTML file that leads to the link and that only the user can read, see `LinkFile`,
  /// and returns its path. The file exists until the link is used or the server ends. Must be
  /// called before `listen`. Throws std::system_error.
  std::filesystem::path link_file();
  /// Serves requests until `stop` is called.
  void listen();
  /// Ends `listen`; may be called from another thread.
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
  /// Functions that answer, by path and method; a number of a job in a path is written ID.
  std::map<std::string, std::map<std::string, Answer>> calls_;
  std::atomic<std::size_t> listeners_ = 0;
};

/// Sets the content and its type of an answer with status 200.
void send(Response& response, std::string content, const char* type);
/// Sets the content of an answer to a JSON value.
void send_json(Response& response, const Json& value);

} // namespace ionskin::apps::studio
