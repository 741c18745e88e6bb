// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <hexagait/viewer/server/host.hpp>

namespace hexagait::viewer {

/// A replay for all who come: each gets the bytes of the file, as one message, and plays it by itself.
class ReplayHost : public Host {
 public:
  explicit ReplayHost(std::string replay) : replay_(std::move(replay)) {}

  void on_news(std::function<void()> /*news*/) override {}
  [[nodiscard]] ClientId enter() override { return ++clients_; }
  void leave(ClientId /*client*/) override {}
  [[nodiscard]] std::string receive(ClientId client, std::string_view message) override;
  [[nodiscard]] bool newer_than(Seen& seen, Letter& letter) const override;

 private:
  std::string replay_;
  std::atomic<ClientId> clients_ = 0;
};

}  // namespace hexagait::viewer
