// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <hexagait/viewer/session.hpp>

// In real time, so each test takes up to a second or two; bounds are wide, as machines are busy.
namespace hexagait::viewer {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;
using testing::IsEmpty;

SessionOptions options(const char* terrain = "flat") {
  SessionOptions result;
  result.robot = load_urdf(HEXAGAIT_ROBOTS "/argos.urdf");
  result.simulation.terrain = sim3d::parse_terrain(terrain);
  result.heading = heading_control::Heading::straight(0.0);
  result.robots = {"argos", "mite", "quadruped"};
  result.load = [](const std::string& name) {
    return LoadedRobot{load_urdf(std::string(HEXAGAIT_ROBOTS "/") + name + ".urdf"), {}};
  };
  return result;
}

// Waits for a frame that is as wanted; the last one otherwise.
template <class Wanted>
PoseFrame frame_when(const Session& session, Wanted wanted) {
  Session::Seen seen;
  Session::Letter letter;
  PoseFrame frame;
  for (int k = 0; k < 500; ++k) {
    while (session.newer_than(seen, letter))
      if (letter.kind == Session::Mail::frame) frame = decode(letter.content);
    if (wanted(frame)) return frame;
    std::this_thread::sleep_for(milliseconds(10));
  }
  ADD_FAILURE() << "no such frame";
  return frame;
}

PoseFrame newest(const Session& session) {
  return frame_when(session, [](const PoseFrame& f) { return f.scene > 0; });
}

TEST(Session, WalksByItselfAndTellsSceneBeforeGroundBeforeFrames) {
  const Session session(options());
  frame_when(session, [](const PoseFrame& f) { return f.path > 0.02; });
  Session::Seen seen;
  Session::Letter letter;
  for (const auto kind : {Session::Mail::scene, Session::Mail::ground, Session::Mail::frame}) {
    ASSERT_TRUE(session.newer_than(seen, letter));
    EXPECT_EQ(letter.kind, kind);
  }
}

TEST(Session, IsSteered) {
  Session session(options());
  const ClientId client = session.enter();
  EXPECT_THAT(session.receive(client, R"({"type":"drive","radius":-2,"crab":0.5})"), IsEmpty());
  const PoseFrame f = frame_when(session, [](const PoseFrame& g) { return g.crab > 0.4; });
  EXPECT_NEAR(f.rho / f.k, -2.0, 1e-5);
  EXPECT_EQ(f.holder, client);
  EXPECT_LE(session.statistics().worst_delay, 1);
}

TEST(Session, ListensToOneAtATime) {
  Session session(options());
  const ClientId first = session.enter(), second = session.enter();
  EXPECT_THAT(session.receive(first, R"({"type":"stop"})"), IsEmpty());
  EXPECT_THAT(session.receive(second, R"({"type":"spin","turn":"cw"})"), HasSubstr("another page"));
  EXPECT_THAT(session.receive(second, R"({"type":"pause","on":true})"), HasSubstr("another page"));
  EXPECT_THAT(session.receive(second, R"({"type":"release"})"), IsEmpty());
  EXPECT_THAT(session.receive(first, R"({"type":"release"})"), IsEmpty());
  EXPECT_THAT(session.receive(second, R"({"type":"spin","turn":"cw"})"), IsEmpty());
  frame_when(session, [&](const PoseFrame& f) { return f.holder == second && f.k < 0.0; });
}

TEST(Session, StopsWhenItsHolderFallsSilent) {
  Session session(options());
  const ClientId client = session.enter();
  EXPECT_THAT(session.receive(client, R"({"type":"drive","curvature":0})"), IsEmpty());
  const auto begin = Clock::now();
  frame_when(session,
             [](const PoseFrame& f) { return (f.flags & PoseFrame::silent) && !f.moving; });
  EXPECT_GE(Clock::now() - begin, milliseconds(450));
  // A sign of life does not move it; a command does.
  EXPECT_THAT(session.receive(client, R"({"type":"beat"})"), IsEmpty());
  std::this_thread::sleep_for(milliseconds(100));
  EXPECT_FALSE(newest(session).moving);
  EXPECT_THAT(session.receive(client, R"({"type":"drive","curvature":0})"), IsEmpty());
  frame_when(session,
             [](const PoseFrame& f) { return f.moving && !(f.flags & PoseFrame::silent); });
}

TEST(Session, GoesOnWhileItsHolderIsAlive) {
  Session session(options());
  const ClientId client = session.enter();
  EXPECT_THAT(session.receive(client, R"({"type":"drive","curvature":0})"), IsEmpty());
  auto last = Clock::now();
  for (int k = 0; k < 15; ++k) {
    std::this_thread::sleep_for(milliseconds(80));
    if (Clock::now() - last > milliseconds(450)) GTEST_SKIP() << "this machine let the test wait";
    EXPECT_THAT(session.receive(client, R"({"type":"beat"})"), IsEmpty());
    last = Clock::now();
  }
  EXPECT_TRUE(newest(session).moving);
}

TEST(Session, StopsWhenItsHolderLeaves) {
  Session session(options());
  const ClientId client = session.enter();
  EXPECT_THAT(session.receive(client, R"({"type":"drive","curvature":0.5})"), IsEmpty());
  frame_when(session, [](const PoseFrame& f) { return f.holder != 0; });
  session.leave(client);
  frame_when(session, [](const PoseFrame& f) { return !f.moving && f.holder == 0; });
}

TEST(Session, RefusedMessagesChangeNothing) {
  Session session(options());
  const ClientId client = session.enter();
  const std::string bad[] = {R"({"type":"drive","radius":NaN})",
                             "\xFF",
                             "{}",
                             std::string(5000, 'x'),
                             R"({"type":"restart","robot":"../../etc/passwd"})",
                             R"({"type":"speed","factor":1e9})"};
  for (const std::string& message : bad)
    EXPECT_THAT(session.receive(client, message), HasSubstr("\"type\":\"error\"")) << message;
  const PoseFrame f = newest(session);
  EXPECT_TRUE(f.moving);
  EXPECT_EQ(f.k, 0.0);
  EXPECT_EQ(f.scene, 1U);
  EXPECT_EQ(f.holder, 0U);
  EXPECT_EQ(session.statistics().commands, 0U);
}

TEST(Session, PausesAndGoesOnTickByTick) {
  Session session(options());
  const ClientId client = session.enter();
  EXPECT_THAT(session.receive(client, R"({"type":"pause","on":true})"), IsEmpty());
  frame_when(session, [](const PoseFrame& f) { return (f.flags & PoseFrame::paused) != 0; });
  const std::uint64_t before = session.statistics().ticks;
  EXPECT_THAT(session.receive(client, R"({"type":"step","ticks":3})"), IsEmpty());
  frame_when(session, [&](const PoseFrame& f) { return f.tick >= before + 3; });
  std::this_thread::sleep_for(milliseconds(100));
  EXPECT_EQ(session.statistics().ticks, before + 3);
  EXPECT_EQ(newest(session).tick, before + 3);
  EXPECT_THAT(session.receive(client, R"({"type":"pause","on":false})"), IsEmpty());
  frame_when(session, [&](const PoseFrame& f) { return f.tick > before + 20; });
}

TEST(Session, TimeRunsAsFastAsIsSaid) {
  Session session(options());
  const ClientId client = session.enter();
  EXPECT_THAT(session.receive(client, R"({"type":"speed","factor":0.1})"), IsEmpty());
  std::this_thread::sleep_for(milliseconds(50));
  const std::uint64_t before = session.statistics().ticks;
  const auto begin = Clock::now();
  std::this_thread::sleep_for(milliseconds(1000));
  const double passed = std::chrono::duration<double>(Clock::now() - begin).count();
  const double simulated = 0.002 * static_cast<double>(session.statistics().ticks - before);
  EXPECT_NEAR(simulated / passed, 0.1, 0.03);
}

TEST(Session, BeginsAnewOnOtherGroundWithAnotherRobot) {
  Session session(options());
  const ClientId client = session.enter();
  EXPECT_THAT(session.receive(client, R"({"type":"restart","terrain":"steps:5cm","seed":4})"),
              IsEmpty());
  frame_when(session, [](const PoseFrame& f) { return f.scene == 2; });
  EXPECT_THAT(session.receive(client, R"({"type":"restart","robot":"quadruped"})"), IsEmpty());
  EXPECT_EQ(frame_when(session, [](const PoseFrame& f) { return f.scene == 3; }).legs.size(), 4);
  EXPECT_THAT(session.receive(client, R"({"type":"reset"})"), IsEmpty());
  EXPECT_EQ(frame_when(session, [](const PoseFrame& f) { return f.scene == 4; }).legs.size(), 6);
}

// 200 g after 50 kg: by its own parameters it is on its way, by those of argos it would jump.
TEST(Session, GivesEachRobotItsOwnParameters) {
  Session session(options("flat"));
  const ClientId client = session.enter();
  EXPECT_THAT(session.receive(client, R"({"type":"restart","robot":"mite"})"), IsEmpty());
  const PoseFrame frame =
      frame_when(session, [](const PoseFrame& f) { return f.scene == 2 && f.path > 0.01; });
  EXPECT_GT(frame.path, 0.01);
  EXPECT_LT(frame.X_WB.p.z(), 0.1);
}

TEST(Session, ScramblesTheLegsWhereItStands) {
  Session session(options("boxes:0.1"));
  const ClientId client = session.enter();
  const PoseFrame before = frame_when(session, [](const PoseFrame& f) { return f.path > 0.1; });
  EXPECT_THAT(session.receive(client, R"({"type":"scramble"})"), IsEmpty());
  const PoseFrame after = frame_when(session, [](const PoseFrame& f) { return f.scene == 2; });
  EXPECT_LT((after.X_WB.p - before.X_WB.p).norm(), 0.2);
}

// Who looks once a second gets the newest frame, not sixty.
TEST(Session, KeepsTheNewestFrameOnly) {
  const Session session(options());
  Session::Seen seen;
  Session::Letter letter;
  while (session.newer_than(seen, letter)) {
  }
  std::this_thread::sleep_for(milliseconds(1000));
  int letters = 0;
  while (session.newer_than(seen, letter)) ++letters;
  EXPECT_LE(letters, 2);  // and one that came in between
  EXPECT_GT(session.statistics().frames, 10U);
}

TEST(Session, RefusesAWalkThatCantBe) {
  SessionOptions bad = options();
  bad.simulation.physics_dt = -1.0;
  EXPECT_THROW(Session{bad}, InvalidInput);
}

}  // namespace
}  // namespace hexagait::viewer
