// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <hexagait/viewer/server/access.hpp>
#include <hexagait/viewer/server/host.hpp>
#include <memory>
#include <string>

namespace hexagait::viewer {

/// Serves the page by HTTP, and a walk or a replay by WebSocket (/ws). Poses and replays are binary
/// messages, all else is JSON text. A client gets the next message when it has taken the last one.
class Server {
 public:
  static constexpr int kMostClients = 8;

  /// Listens from now on.
  /// @param access   port 0: any that is free
  /// @param host     must outlive the server
  /// @throws InvalidInput  if the address or the port can't be had, with the option that changes it
  Server(Access access, Host& host);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Answers until `stop`.
  void run(const std::atomic<bool>& stop);

  [[nodiscard]] int port() const;
  /// Where the page is, with the token if it needs one.
  [[nodiscard]] std::string url() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hexagait::viewer
