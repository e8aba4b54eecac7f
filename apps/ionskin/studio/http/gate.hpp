// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/http/bounded_pool.hpp"
#include "studio/http/request_reader.hpp"
#include "studio/http/response.hpp"

#include <atomic>
#include <chrono>
#include <memory>
#include <vector>

namespace ionskin::apps::studio {

/// HTTP server on the loopback interface. One thread reads all connections; each request has a
/// bounded size and time, so that a slow client does not keep others waiting. Worker threads answer
/// requests that were admitted and have arrived whole. A connection serves one request.
class Gate {
public:
  /// Decides by its head whether a request is admitted, see `RequestReader::Judge`; called in the
  /// thread of `serve`.
  using Judge = RequestReader::Judge;
  /// Answers an admitted request; called in worker threads, and must not throw.
  using Answer = std::function<Response(Request&)>;

  /// Opens the port.
  /// @param port TCP port of 127.0.0.1; 0 for any free port
  /// Throws UserError when the port is taken.
  explicit Gate(int port);
  ~Gate();
  Gate(const Gate&) = delete;
  Gate& operator=(const Gate&) = delete;

  /// TCP port on which the server listens.
  int port() const { return port_; }
  /// Serves requests until `stop` is called.
  void serve(const Judge& judge, const Answer& answer);
  /// Ends `serve`; may be called from another thread.
  void stop();

private:
  using Clock = std::chrono::steady_clock;
  struct Connection;

  void wait();
  void receive(std::shared_ptr<Connection>& connection, const Judge& judge, const Answer& answer);
  std::size_t admit(Connection& connection, const Request& head, const Judge& judge);
  void reply(Connection& connection, const Answer& answer) const;
  void accept_all();
  void drop_oldest();
  bool send_all(int socket, std::string_view text) const;

  int port_ = 0, listener_ = -1, wake_ = -1;
  std::atomic<bool> ends_ = false;
  /// Size of all bodies that are awaited or being answered [bytes].
  std::atomic<std::size_t> bodies_ = 0;
  /// Connections that are read, the oldest first.
  std::vector<std::shared_ptr<Connection>> connections_;
  std::unique_ptr<BoundedPool> workers_;
};

} // namespace ionskin::apps::studio
