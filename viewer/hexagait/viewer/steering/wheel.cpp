// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/viewer/steering/wheel.hpp>

namespace hexagait::viewer {

void Wheel::enter(ClientId client, Clock::time_point now) { clients_[client] = {.heard = now}; }

bool Wheel::leave(ClientId client) {
  clients_.erase(client);
  const bool held = holder_ == client;
  if (held) holder_ = 0;
  return held;
}

bool Wheel::hear(ClientId client, Clock::time_point now) {
  const auto found = clients_.find(client);
  if (found == clients_.end()) return false;
  Client& one = found->second;
  const double passed = std::chrono::duration<double>(now - one.heard).count();
  one.allowed = std::min(kBurst, one.allowed + kRate * passed);
  one.heard = now;
  if (one.allowed < 1.0) return false;
  one.allowed -= 1.0;
  return true;
}

bool Wheel::take(ClientId client, Clock::time_point now) {
  const auto found = clients_.find(holder_);
  if (found != clients_.end() && holder_ != client && now - found->second.heard <= kGone)
    return false;
  holder_ = client;
  return true;
}

void Wheel::release(ClientId client) {
  if (holder_ == client) holder_ = 0;
}

bool Wheel::is_silent(Clock::time_point now) const {
  const auto found = clients_.find(holder_);
  return found != clients_.end() && now - found->second.heard > kSilence;
}

}  // namespace hexagait::viewer
