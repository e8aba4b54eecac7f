// SPDX-License-Identifier: Apache-2.0
#include "studio/server/server.hpp"

#include "ionskin/base/error.hpp"
#include "studio/server/body_bytes.hpp"
#include "studio/server/page_files.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ionskin::apps::studio {
namespace {

constexpr std::string_view link_folder = "/open/";

/// Replaces the number of a job in a path by ID and returns the path: "/api/jobs/7/cancel" becomes
/// "/api/jobs/ID/cancel".
/// @param id set to the number
std::string call_of(const std::string& path, std::string& id) {
  constexpr std::string_view jobs = "/api/jobs/";
  if (!path.starts_with(jobs)) {
    return path;
  }
  const std::size_t end = std::min(path.find_first_not_of("0123456789", jobs.size()), path.size());
  id = path.substr(jobs.size(), end - jobs.size());
  return id.empty() || id.size() > 20 ? path : std::string(jobs) + "ID" + path.substr(end);
}

} // namespace

void send(Response& response, std::string content, const char* type) {
  response.type = type;
  response.body = std::move(content);
}

void send_json(Response& response, const Json& value) {
  send(response, dump(value), json_type);
}

Server::Server(Workspace& workspace, JobQueue& jobs, int port)
    : workspace_(workspace), jobs_(jobs), gate_(port), access_(gate_.port()) {
  for (const char* const path : {"/", "/app.js", "/app.css"}) {
    get(path, [file = page_file(path)](const Request&, Response& response) {
      send(response, std::string(file.content), file.type);
    });
  }
  serve_case_calls();
  serve_job_calls();
  serve_result_calls();
  serve_file_calls();
}

std::string Server::link() const {
  return fmt::format("http://127.0.0.1:{}{}", gate_.port(), access_.link_path());
}

std::filesystem::path Server::link_file() {
  return link_file_.emplace(link()).path();
}

void Server::listen() {
  gate_.serve([this](const Request& head) { return admit(head); },
              [this](Request& request) { return answer(request); });
}

void Server::stop() {
  jobs_.close();
  gate_.stop();
}

/// Decides whether a request may be answered, and returns the size of its body [bytes]. Throws
/// HttpError to refuse it.
std::size_t Server::admit(const Request& head) const {
  access_.require_own_origin(head);
  const bool known = access_.has_cookie(head);
  if (head.path.starts_with(link_folder) && !known && !access_.opens(head)) {
    throw HttpError(403, "this link was used before, or is not the one that the Studio printed: "
                         "start ionskin studio again for a new one");
  }
  if (!known && !access_.opens(head)) {
    throw HttpError(401, "open the link that ionskin studio printed");
  }
  return body_bytes(head);
}

/// Answers a request; an exception becomes an answer with its status and message.
Response Server::answer(Request& request) {
  try {
    Response response;
    route(request, response);
    return response;
  } catch (const HttpError& error) {
    return error_response(error.status(), error.what());
  } catch (const UserError& error) {
    return error_response(422, error.what());
  } catch (const Json::exception&) {
    return error_response(400, "the request has a value of another type than expected");
  } catch (const std::exception& error) {
    return error_response(500, error.what());
  }
}

void Server::route(Request& request, Response& response) {
  if (request.path.starts_with(link_folder)) {
    open(request, response);
    return;
  }
  const auto call = calls_.find(call_of(request.path, request.id));
  if (call == calls_.end()) {
    throw HttpError(404, "there is no such page");
  }
  const auto answer = call->second.find(request.method == "HEAD" ? "GET" : request.method);
  if (answer == call->second.end()) {
    throw HttpError(405, fmt::format("{} is not served here", request.method));
  }
  answer->second(request, response);
}

/// Answers a request of the one-time link: gives the browser the cookie once, and leads it to the
/// page.
void Server::open(const Request& request, Response& response) {
  const std::string cookie = access_.redeem(request);
  if (!cookie.empty()) {
    response.headers.emplace_back("Set-Cookie", cookie);
    link_file_.reset();
  } else if (!access_.has_cookie(request)) {
    throw HttpError(403, "this link was used before");
  }
  const std::string site = request.header("sec-fetch-site");
  if (site.empty() || site == "none") {
    response.status = 303;
    response.headers.emplace_back("Location", "/");
    return;
  }
  // A page of another origin led here, such as the file for the browser: along a redirection the
  // browser would keep the cookie back.
  send(response, "<!DOCTYPE html>\n<meta http-equiv=\"refresh\" content=\"0; url=/\">\n",
       "text/html; charset=utf-8");
}

void Server::get(const std::string& path, Answer answer) {
  calls_[path]["GET"] = std::move(answer);
}

void Server::post(const std::string& path, Answer answer) {
  calls_[path]["POST"] = std::move(answer);
}

} // namespace ionskin::apps::studio
