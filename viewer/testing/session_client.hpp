// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/viewer/session/session.hpp>
#include <string>
#include <string_view>

namespace hexagait::viewer::testing {

/// Waits for a frame that is as wanted; the last one otherwise.
/// @param setup  if not null, becomes the newest setup that came before it
template <class Wanted>
PoseFrame frame_when(const Session& session, Wanted wanted, std::string* setup = nullptr) {
  Session::Seen seen;
  Session::Letter letter;
  PoseFrame frame;
  for (int k = 0; k < 500; ++k) {
    while (session.newer_than(seen, letter)) {
      std::string_view frames = letter.content;  // of a race, two
      if (letter.kind == Session::Mail::frame) frame = decode_front(frames);
      if (letter.kind == Session::Mail::setup && setup != nullptr) *setup = letter.content;
    }
    if (wanted(frame)) return frame;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ADD_FAILURE() << "no such frame";
  return frame;
}

/// The same while the client goes on holding the wheel.
template <class Wanted>
PoseFrame held_until(Session& session, ClientId client, Wanted wanted,
                     std::string* setup = nullptr) {
  const auto beat_and_ask = [&](const PoseFrame& f) {
    EXPECT_THAT(session.receive(client, R"({"type":"beat"})"), ::testing::IsEmpty());
    return wanted(f);
  };
  return frame_when(session, beat_and_ask, setup);
}

}  // namespace hexagait::viewer::testing
