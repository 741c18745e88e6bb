// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/viewer/display/scene.hpp>
#include <hexagait/viewer/replay/replay_host.hpp>

namespace hexagait::viewer {

std::string ReplayHost::receive(ClientId /*client*/, std::string_view /*message*/) {
  return error_json("this is a replay: there is nothing to steer");
}

bool ReplayHost::newer_than(Seen& seen, Letter& letter) const {
  std::uint64_t& number = seen.number[static_cast<int>(Mail::frame)];
  if (number != 0) return false;
  number = 1;
  letter = {Mail::frame, replay_};
  return true;
}

}  // namespace hexagait::viewer
