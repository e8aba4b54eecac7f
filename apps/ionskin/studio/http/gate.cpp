// SPDX-License-Identifier: Apache-2.0
#include "studio/http/gate.hpp"

#include "ionskin/base/error.hpp"
#include "studio/server/http_error.hpp"
#include "studio/server/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <netinet/in.h>
#include <new>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace ionskin::apps::studio {

using Stage = RequestReader::Stage;

struct Gate::Connection {
  Connection(int opened, std::atomic<std::size_t>& all_bodies)
      : socket(opened), deadline(Clock::now() + limits::head_time), bodies(all_bodies) {}
  ~Connection() {
    ::close(socket);
    bodies -= reader.body_length();
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Marks the connection to be closed in the next turn of `serve`.
  void end() { deadline = Clock::time_point::min(); }

  int socket;
  Clock::time_point deadline;
  std::atomic<std::size_t>& bodies;
  RequestReader reader;
  /// The request was refused and answered; data that still arrive are discarded.
  bool refused = false;
  std::size_t passed_over = 0; ///< discarded data [bytes]
  bool ready = false;
};

Gate::Gate(int port) {
  wake_ = ::eventfd(0, EFD_CLOEXEC);
  listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const int yes = 1;
  ::setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  auto* const place = reinterpret_cast<sockaddr*>(&address);
  socklen_t size = sizeof address;
  if (wake_ < 0 || ::bind(listener_, place, size) != 0 ||
      ::listen(listener_, static_cast<int>(limits::waiting)) != 0 ||
      ::getsockname(listener_, place, &size) != 0) {
    ::close(listener_);
    ::close(wake_);
    throw UserError(
        fmt::format("port {} cannot be used\n  = leave --port out, and a free one is taken", port));
  }
  port_ = ntohs(address.sin_port);
}

Gate::~Gate() {
  ::close(listener_);
  ::close(wake_);
}

void Gate::serve(const Judge& judge, const Answer& answer) {
  workers_ = std::make_unique<BoundedPool>(limits::workers, limits::waiting);
  while (!ends_) {
    wait();
    for (auto& connection : connections_) {
      if (connection->ready) {
        receive(connection, judge, answer);
      }
    }
    const auto now = Clock::now();
    std::erase_if(connections_, [now](const auto& one) { return !one || one->deadline <= now; });
    accept_all();
  }
  connections_.clear();
  workers_.reset();
}

void Gate::stop() {
  ends_ = true;
  ::eventfd_write(wake_, 1); // stays readable
}

/// Waits for data, a new connection, the next deadline, or `stop`.
void Gate::wait() {
  std::vector<pollfd> ends{{wake_, POLLIN, 0}, {listener_, POLLIN, 0}};
  auto next = Clock::now() + std::chrono::seconds(60);
  for (const auto& connection : connections_) {
    ends.push_back({connection->socket, POLLIN, 0});
    next = std::min(next, connection->deadline);
  }
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(next - Clock::now()).count();
  const bool any = ::poll(ends.data(), ends.size(), static_cast<int>(std::max(left, 0L))) > 0;
  for (std::size_t i = 0; i < connections_.size(); ++i) {
    connections_[i]->ready = any && ends[i + 2].revents != 0;
  }
}

/// Reads the data that have arrived on a connection. When its request is whole, a worker takes over
/// request and connection.
void Gate::receive(std::shared_ptr<Connection>& connection, const Judge& judge,
                   const Answer& answer) {
  std::array<char, 65536> buffer;
  const ssize_t count = ::recv(connection->socket, buffer.data(), buffer.size(), MSG_DONTWAIT);
  if (count <= 0) {
    if (count == 0 || (errno != EAGAIN && errno != EINTR)) {
      connection->end();
    }
    return;
  }
  const std::string_view bytes(buffer.data(), static_cast<std::size_t>(count));
  if (connection->refused) {
    connection->passed_over += bytes.size();
    if (connection->passed_over > limits::passed_over) {
      connection->end();
    }
    return;
  }
  try {
    const auto stage = connection->reader.take(
        bytes, [&](const Request& head) { return admit(*connection, head, judge); });
    if (stage == Stage::whole) {
      workers_->enqueue([this, connection, answer] { reply(*connection, answer); });
      connection.reset();
    }
  } catch (const HttpError& error) {
    // Closed at once, the line would be reset, and the client might never read the answer.
    const Response response = error_response(error.status(), error.what());
    const bool content = connection->reader.request().method != "HEAD";
    const std::string text = head_of(response) + (content ? response.body : "");
    ::send(connection->socket, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    ::shutdown(connection->socket, SHUT_WR);
    connection->refused = true;
    connection->deadline = Clock::now() + limits::passing_time;
  } catch (const std::bad_alloc&) {
    connection->end();
  }
}

std::size_t Gate::admit(Connection& connection, const Request& head, const Judge& judge) {
  const std::size_t length = judge(head);
  if (bodies_ + length > limits::bodies) {
    throw HttpError(503, "too many bodies are sent at once; send it again");
  }
  bodies_ += length; // given back with the connection
  connection.deadline = Clock::now() + limits::body_time;
  if (length > 0 && head.header("expect") == "100-continue") {
    constexpr std::string_view go_on = "HTTP/1.1 100 Continue\r\n\r\n";
    ::send(connection.socket, go_on.data(), go_on.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  }
  return length;
}

void Gate::reply(Connection& connection, const Answer& answer) const {
  Request& request = connection.reader.request();
  const Response response = answer(request);
  const auto write = [&](std::string_view text) { return send_all(connection.socket, text); };
  if (write(head_of(response)) && request.method != "HEAD") {
    if (response.stream) {
      try {
        response.stream(write);
      } catch (const std::exception&) {
        return; // too late for a status: the end of the line ends the content
      }
    } else {
      write(response.body);
    }
  }
  ::shutdown(connection.socket, SHUT_WR);
}

void Gate::accept_all() {
  for (int i = 0; i < 32; ++i) {
    const int socket = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
    if (socket < 0) {
      if (errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM) {
        drop_oldest();
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
      return;
    }
    if (connections_.size() == limits::connections) {
      drop_oldest();
    }
    connections_.push_back(std::make_shared<Connection>(socket, bodies_));
  }
}

/// Closes the oldest connection that was not admitted, or else the oldest of all.
void Gate::drop_oldest() {
  auto oldest = std::ranges::find_if(
      connections_, [](const auto& one) { return one->reader.stage() == Stage::head; });
  if (oldest == connections_.end()) {
    oldest = connections_.begin();
  }
  if (oldest != connections_.end()) {
    connections_.erase(oldest);
  }
}

/// Sends a text, for which the whole time is bounded. Returns false when the connection is lost,
/// the time is over, or the server ends.
bool Gate::send_all(int socket, std::string_view text) const {
  const auto deadline = Clock::now() + limits::answer_time;
  while (!text.empty()) {
    const ssize_t count = ::send(socket, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count > 0) {
      text.remove_prefix(static_cast<std::size_t>(count));
      continue;
    }
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    std::array<pollfd, 2> ends{pollfd{socket, POLLOUT, 0}, pollfd{wake_, POLLIN, 0}};
    if ((errno != EAGAIN && errno != EINTR) || left.count() <= 0 ||
        ::poll(ends.data(), ends.size(), static_cast<int>(left.count())) == 0 || ends_) {
      return false;
    }
  }
  return true;
}

} // namespace ionskin::apps::studio
