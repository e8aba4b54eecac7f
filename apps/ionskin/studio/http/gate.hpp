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

/// The server's end of HTTP on the loopback. One thread reads all connections, each within a size
/// and a time for the whole of its request, so that none keeps others waiting; workers see whole
/// requests that were admitted. A connection serves one request.
class Gate {
public:
  /// Admits a request by its head, as `RequestReader::Judge`; called by the thread of `serve`.
  using Judge = RequestReader::Judge;
  /// Answers a request that was admitted; called by the workers, and throws nothing.
  using Answer = std::function<Response(Request&)>;

  /// @param port of 127.0.0.1; 0 for any that is free
  /// Throws UserError when the port is taken.
  explicit Gate(int port);
  ~Gate();
  Gate(const Gate&) = delete;
  Gate& operator=(const Gate&) = delete;

  int port() const { return port_; }
  /// Serves until `stop`.
  void serve(const Judge& judge, const Answer& answer);
  /// May be called from another thread.
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
  std::atomic<std::size_t> bodies_ = 0; ///< bytes of all bodies that are awaited or answered
  std::vector<std::shared_ptr<Connection>>
      connections_; ///< connections that are read, the oldest first
  std::unique_ptr<BoundedPool> workers_;
};

} // namespace ionskin::apps::studio
