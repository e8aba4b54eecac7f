// SPDX-License-Identifier: Apache-2.0
#include "studio/server/server.hpp"

#include "ionskin/base/error.hpp"
#include "studio/server/bounded_pool.hpp"
#include "studio/server/limits.hpp"
#include "studio/server/page_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <sys/socket.h>

namespace ionskin::apps::studio {
namespace {

// uPlot places its parts through the style attributes of elements, which scripts may set anyhow.
constexpr const char* content_policy =
    "default-src 'self'; img-src 'self' data: blob:; style-src 'self'; object-src 'none'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

void add_safety_headers(httplib::Response& response) {
  response.set_header("Content-Security-Policy", content_policy);
  response.set_header("X-Content-Type-Options", "nosniff");
  response.set_header("X-Frame-Options", "DENY");
  response.set_header("Referrer-Policy", "no-referrer");
  response.set_header("Cross-Origin-Opener-Policy", "same-origin");
  response.set_header("Cross-Origin-Resource-Policy", "same-origin");
  response.set_header("Cache-Control", "no-store");
}

void fail(httplib::Response& response, int status, const std::string& message) {
  response.status = status;
  send_json(response, {{"error", message}});
}

/// Runs an answer; what it throws becomes the status and a message.
void guarded(const std::function<void()>& answer, httplib::Response& response) {
  try {
    answer();
  } catch (const HttpError& error) {
    fail(response, error.status(), error.what());
  } catch (const UserError& error) {
    fail(response, 422, error.what());
  } catch (const Json::exception&) {
    fail(response, 400, "the request has a value of another type than expected");
  } catch (const std::exception& error) {
    fail(response, 500, error.what());
  }
}

/// Refuses bodies before a byte of them is read: too large, of unknown length, or packed.
void require_small_body(const httplib::Request& request) {
  if (request.method == "GET" || request.method == "HEAD") {
    if (request.has_header("Content-Length") || request.has_header("Transfer-Encoding")) {
      throw HttpError(400, "this request has no body");
    }
    return;
  }
  if (request.has_header("Transfer-Encoding") || request.has_header("Content-Encoding") ||
      request.get_header_value_count("Content-Length") != 1) {
    throw HttpError(411, "the length of the body is told beforehand, and it is not packed");
  }
  const std::string length = request.get_header_value("Content-Length");
  const bool upload = request.path == "/api/upload";
  std::size_t bytes = 0;
  const auto [end, problem] = std::from_chars(length.data(), length.data() + length.size(), bytes);
  if (problem != std::errc() || end != length.data() + length.size() ||
      bytes > (upload ? limits::upload : limits::body)) {
    throw HttpError(413, fmt::format("a body has {} MiB at most",
                                     (upload ? limits::upload : limits::body) >> 20));
  }
  const std::string type = request.get_header_value("Content-Type");
  if (type != (upload ? "text/csv" : "application/json")) {
    throw HttpError(415, "the body is JSON (application/json), or a CSV file (text/csv)");
  }
}

} // namespace

void send(httplib::Response& response, std::string content, const char* type) {
  if (content.empty()) {
    response.set_content(content, type);
    return;
  }
  const auto kept = std::make_shared<const std::string>(std::move(content));
  response.set_content_provider(
      kept->size(), type, [kept](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
        const std::string_view part = std::string_view(*kept).substr(offset, length);
        return sink.write(part.data(), part.size());
      });
}

void send_json(httplib::Response& response, const Json& value) {
  send(response, dump(value), "application/json; charset=utf-8");
}

Server::Server(Workspace& workspace, JobQueue& jobs, int port)
    : workspace_(workspace), jobs_(jobs) {
  http_.new_task_queue = [] { return new BoundedPool(limits::workers, limits::waiting); };
  http_.set_keep_alive_max_count(1);
  http_.set_read_timeout(5);
  http_.set_write_timeout(10);
  http_.set_payload_max_length(limits::upload);
  socket_t socket = INVALID_SOCKET;
  http_.set_socket_options([&socket](socket_t opened) {
    const int yes = 1;
    setsockopt(opened, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    socket = opened;
  });
  port_ = port == 0 ? http_.bind_to_any_port("127.0.0.1")
                    : (http_.bind_to_port("127.0.0.1", port) ? port : -1);
  if (port_ <= 0) {
    throw UserError(fmt::format("port {} cannot be used\n  = leave --port out, and a free one is "
                                "taken",
                                port));
  }
  ::listen(socket, static_cast<int>(limits::waiting)); // the library's own line has five places
  access_ = std::make_unique<Access>(port_);
  http_.set_pre_routing_handler(
      [this](const httplib::Request& request, httplib::Response& response) {
        return admit(request, response);
      });
  http_.set_expect_100_continue_handler(
      [](const httplib::Request& request, httplib::Response& response) {
        try {
          require_small_body(request);
        } catch (const HttpError& error) {
          response.status = error.status();
          return error.status();
        }
        return 100;
      });
  serve_case_calls();
  serve_job_calls();
  serve_result_calls();
  serve_file_calls();
}

std::string Server::link() const {
  return fmt::format("http://127.0.0.1:{}{}", port_, access_->link_path());
}

void Server::listen() {
  http_.listen_after_bind();
}

void Server::stop() {
  jobs_.close();
  http_.stop();
}

Server::Handled Server::admit(const httplib::Request& request, httplib::Response& response) {
  // Every answer is sent whole: the library asks a provider for bytes beyond its end when a request
  // names a range there. It passes its own request, which is not constant.
  const_cast<httplib::Request&>(request).ranges.clear();
  add_safety_headers(response);
  response.set_header("Accept-Ranges", "none");
  Handled handled = Handled::Handled;
  const auto gate = [&] {
    access_->require_own_origin(request);
    const bool known = access_->has_cookie(request);
    if (request.path.rfind("/open/", 0) == 0 && request.method == "GET") {
      const std::string cookie = access_->redeem(request.path);
      if (cookie.empty() && !known) {
        throw HttpError(403,
                        "this link was used before, or is not the one that the Studio printed: "
                        "start ionskin studio again for a new one");
      }
      if (!cookie.empty()) {
        response.set_header("Set-Cookie", cookie);
      }
      response.set_redirect("/", 303);
      return;
    }
    if (!known) {
      throw HttpError(401, "open the link that ionskin studio printed");
    }
    require_small_body(request);
    const PageFile file = request.method == "GET" ? page_file(request.path) : PageFile{};
    if (!file.content.empty()) {
      send(response, std::string(file.content), std::string(file.type).c_str());
      return;
    }
    handled = Handled::Unhandled;
  };
  guarded(gate, response);
  if (handled == Handled::Unhandled) {
    response.status = -1; // the library fills it in
  }
  return handled;
}

void Server::get(const std::string& path, Answer answer) {
  http_.Get(path, [answer](const httplib::Request& request, httplib::Response& response) {
    guarded([&] { answer(request, response); }, response);
  });
}

void Server::post(const std::string& path, Answer answer) {
  http_.Post(path, [answer](const httplib::Request& request, httplib::Response& response) {
    guarded([&] { answer(request, response); }, response);
  });
}

} // namespace ionskin::apps::studio
