// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <hexagait/viewer/session/session.hpp>
#include <testing/argos_walk.hpp>
#include <testing/session_client.hpp>
#include <testing/source_path.hpp>

// In real time, so each test takes up to a second or two; bounds are wide, as machines are busy.
namespace hexagait::viewer::session_test {
namespace {

using std::chrono::milliseconds;
using testing::frame_when;
using ::testing::HasSubstr;
using testing::held_until;
using ::testing::IsEmpty;

SessionOptions options(const char* terrain = "flat") {
  SessionOptions result;
  result.robot = testing::argos();
  result.simulation.terrain = sim3d::parse_terrain(terrain);
  result.heading = heading_control::Heading::straight(0.0);
  result.robots = {"argos", "mite", "quadruped"};
  result.load = [](const std::string& name) {
    return LoadedRobot{load_urdf(hexagait::testing::source_path("robots/" + name + ".urdf")), {}};
  };
  return result;
}

PoseFrame newest(const Session& session) {
  return frame_when(session, [](const PoseFrame& f) { return f.scene > 0; });
}

// The newest setup, once there is one that has this text in it.
std::string setup_with(const Session& session, const std::string& text) {
  Session::Letter letter;
  for (int k = 0; k < 500; ++k) {
    Session::Seen seen;
    while (session.newer_than(seen, letter))
      if (letter.kind == Session::Mail::setup && letter.content.find(text) != std::string::npos)
        return letter.content;
    std::this_thread::sleep_for(milliseconds(10));
  }
  return "no setup with " + text;
}

std::string notice(const Session& session) {
  Session::Letter letter;
  for (int k = 0; k < 500; ++k) {
    Session::Seen seen;
    while (session.newer_than(seen, letter))
      if (letter.kind == Session::Mail::notice) return letter.content;
    std::this_thread::sleep_for(milliseconds(10));
  }
  return "no notice";
}

TEST(Session, WalksByItselfAndTellsSceneBeforeGroundBeforeFrames) {
  const Session session(options());
  frame_when(session, [](const PoseFrame& f) { return f.path > 0.02; });
  Session::Seen seen;
  Session::Letter letter;
  using Mail = Session::Mail;
  for (const auto kind : {Mail::scene, Mail::ground, Mail::setup, Mail::frame}) {
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
      held_until(session, client, [](const PoseFrame& f) { return f.scene == 2 && f.path > 0.01; });
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

// In the same scene, at once; until it is mended, where the robot is.
TEST(Session, BreaksAndMends) {
  Session session(options());
  const ClientId client = session.enter();
  EXPECT_THAT(session.receive(client, R"({"type":"speed","factor":4})"), IsEmpty());
  frame_when(session, [](const PoseFrame& f) { return f.path > 0.05; });
  EXPECT_THAT(session.receive(client, R"({"type":"drive","curvature":0})"), IsEmpty());
  EXPECT_THAT(session.receive(client, R"({"type":"fault","fault":"cut:RM"})"), IsEmpty());
  EXPECT_THAT(setup_with(session, "cut:RM"), HasSubstr(R"("scene":1)"));
  const PoseFrame lost =
      held_until(session, client, [](const PoseFrame& f) { return f.legs[3].phase == kLost; });
  EXPECT_FALSE(lost.contact.contains(3));
  EXPECT_TRUE(lost.legs[3].p_WT.array().isNaN().all());
  EXPECT_THAT(session.receive(client, R"({"type":"mend"})"), IsEmpty());
  const PoseFrame mended =
      held_until(session, client, [](const PoseFrame& f) { return f.scene == 2; });
  EXPECT_LT((mended.X_WB.p - lost.X_WB.p).head<2>().norm(), 0.3);
  EXPECT_THAT(setup_with(session, R"("scene":2)"), HasSubstr(R"("faults":[])"));
  held_until(session, client,
             [](const PoseFrame& f) { return f.contact.contains(3) && f.legs[3].phase != kLost; });
}

// With one leg on a side it can't walk, whatever it is told.
TEST(Session, SaysThatItRefusesToWalk) {
  Session session(options());
  const ClientId client = session.enter();
  for (const char* order :
       {R"({"type":"fault","fault":"cut:LF"})", R"({"type":"fault","fault":"cut:LR"})",
        R"({"type":"drive","curvature":0})"})
    EXPECT_THAT(session.receive(client, order), IsEmpty());
  const auto refuses = [](const PoseFrame& f) { return (f.flags & PoseFrame::refuses) != 0; };
  EXPECT_FALSE(held_until(session, client, refuses).moving);
  EXPECT_THAT(session.receive(client, R"({"type":"stop"})"), IsEmpty());
  held_until(session, client, [&](const PoseFrame& f) { return !refuses(f); });
}

TEST(Session, RefusesFaultsOfOtherRobotsAndChangesNothing) {
  Session session(options());
  const ClientId client = session.enter();
  EXPECT_THAT(session.receive(client, R"({"type":"fault","fault":"dead:L9"})"), IsEmpty());
  EXPECT_THAT(notice(session), HasSubstr("argos has no leg 'L9'"));
  EXPECT_THAT(setup_with(session, "setup"), HasSubstr(R"("faults":[])"));
  EXPECT_EQ(newest(session).scene, 1U);
}

// A push passes; a load is there from a new beginning on, in the same place. Another robot has neither.
TEST(Session, KeepsFaultsAsLongAsTheRobotHasThem) {
  Session session(options());
  const ClientId client = session.enter();
  frame_when(session, [](const PoseFrame& f) { return f.path > 0.05; });
  EXPECT_THAT(session.receive(client, R"({"type":"fault","fault":"push:5Ns:90deg"})"), IsEmpty());
  EXPECT_THAT(session.receive(client, R"({"type":"fault","fault":"dead:LF"})"), IsEmpty());
  EXPECT_THAT(setup_with(session, "dead:LF"), HasSubstr(R"("faults":["dead:LF"])"));
  EXPECT_THAT(session.receive(client, R"({"type":"fault","fault":"load:5kg:0:0"})"), IsEmpty());
  EXPECT_THAT(setup_with(session, "load"), HasSubstr(R"("scene":2)"));
  EXPECT_THAT(session.receive(client, R"({"type":"plant","plant":"real"})"), IsEmpty());
  EXPECT_THAT(setup_with(session, R"("scene":3)"),
              HasSubstr(R"("plant":"real","faults":["dead:LF","load:5kg:0:0"])"));
  EXPECT_THAT(session.receive(client, R"({"type":"restart","robot":"quadruped"})"), IsEmpty());
  EXPECT_THAT(setup_with(session, R"("scene":4)"), HasSubstr(R"("plant":"real","faults":[])"));
}

// To the end, where it stands; the path is told until somebody steers.
TEST(Session, FollowsAPathThatIsDrawn) {
  Session session(options());
  const ClientId client = session.enter();
  EXPECT_THAT(session.receive(client, R"({"type":"speed","factor":10})"), IsEmpty());
  const PoseFrame begin = newest(session);
  const Vector2 a = begin.X_WB.p.head<2>() + Vector2(0.3, 0.1), b = a + Vector2(0.4, 0.3);
  const std::string path =
      fmt::format(R"({{"type":"follow","points":[[{},{}],[{},{}]]}})", a.x(), a.y(), b.x(), b.y());
  EXPECT_THAT(session.receive(client, path), IsEmpty());
  held_until(session, client,
             [](const PoseFrame& f) { return (f.flags & PoseFrame::follows) != 0; });
  EXPECT_THAT(setup_with(session, "points"), HasSubstr(R"("closed":false)"));
  const PoseFrame end = held_until(session, client, [](const PoseFrame& f) {
    return (f.flags & PoseFrame::follows) == 0 && f.path > 0.3;
  });
  EXPECT_FALSE(end.moving);
  EXPECT_LT((end.X_WB.p.head<2>() - b).norm(), 0.05);
  EXPECT_LT(std::abs(end.lateral), 0.05);
  EXPECT_THAT(session.receive(client, R"({"type":"drive","curvature":0})"), IsEmpty());
  EXPECT_THAT(setup_with(session, R"("path":null)"), HasSubstr("setup"));
}

TEST(Session, RefusesPathsAndGoesOn) {
  Session session(options());
  const ClientId client = session.enter();
  EXPECT_THAT(session.receive(client, R"({"type":"follow","path":"/etc/passwd"})"),
              HasSubstr("there is no path"));
  EXPECT_THAT(session.receive(client, R"({"type":"follow","points":[[0,0],[2,0],[1.99,0]]})"),
              IsEmpty());
  EXPECT_THAT(notice(session), HasSubstr("it doubles back"));
  const PoseFrame f = newest(session);
  EXPECT_TRUE(f.moving);
  EXPECT_FALSE(f.flags & PoseFrame::follows);
  EXPECT_EQ(f.scene, 1U);
}

// Silence interrupts it; the same path again goes on from where it was, and not from its first point.
TEST(Session, GoesOnAlongThePathOnWhichItWasInterrupted) {
  Session session(options());
  const ClientId client = session.enter();
  EXPECT_THAT(session.receive(client, R"({"type":"speed","factor":10})"), IsEmpty());
  const char* const path = R"({"type":"follow","points":[[0,0],[20,0]]})";
  const auto far = [](double x) { return [x](const PoseFrame& f) { return f.X_WB.p.x() > x; }; };
  EXPECT_THAT(session.receive(client, path), IsEmpty());
  held_until(session, client, far(1.0));
  const PoseFrame stopped = frame_when(session, [](const PoseFrame& f) {
    return (f.flags & PoseFrame::silent) && !(f.flags & PoseFrame::follows) && !f.moving;
  });
  EXPECT_THAT(session.receive(client, path), IsEmpty());
  held_until(session, client, far(stopped.X_WB.p.x() + 0.2));
}

// A robot that is in no list: from a file. After another one it comes back.
TEST(Session, TheRobotThatItBeganWithCanBeChosen) {
  SessionOptions own = options();
  own.robot.name = "mine";
  Session session(own);
  const ClientId client = session.enter();
  EXPECT_THAT(session.receive(client, R"({"type":"restart","robot":"quadruped"})"), IsEmpty());
  frame_when(session, [](const PoseFrame& f) { return f.legs.size() == 4; });
  EXPECT_THAT(session.receive(client, R"({"type":"restart","robot":"mine"})"), IsEmpty());
  frame_when(session, [](const PoseFrame& f) { return f.scene == 3 && f.legs.size() == 6; });
}

// A second robot on the same ground, told the same, of another gait; after a reset it is gone.
TEST(Session, RacesTwoRobots) {
  Session session(options("boxes:5cm"));
  const ClientId client = session.enter();
  EXPECT_THAT(session.receive(client, R"({"type":"speed","factor":4})"), IsEmpty());
  EXPECT_THAT(session.receive(client, R"({"type":"race","on":true,"gait":"tripod"})"), IsEmpty());
  EXPECT_THAT(session.receive(client, R"({"type":"drive","curvature":0})"), IsEmpty());
  EXPECT_THAT(setup_with(session, "tripod"), HasSubstr(R"("race":"tripod")"));
  Session::Seen seen;
  Session::Letter letter;
  PoseFrame own, rival;
  for (int k = 0; k < 3000 && rival.path < 1.5; ++k) {
    EXPECT_THAT(session.receive(client, R"({"type":"beat"})"), IsEmpty());
    while (session.newer_than(seen, letter)) {
      if (letter.kind != Session::Mail::frame) continue;
      std::string_view frames = letter.content;
      own = decode_front(frames);
      if (!frames.empty()) rival = decode(frames);
      if (rival.scene == own.scene) {
        EXPECT_EQ(own.time, rival.time);  // of one moment, however slow the client is
      }
    }
    std::this_thread::sleep_for(milliseconds(10));
  }
  EXPECT_GT(rival.path, 0.3);
  EXPECT_EQ(own.time, rival.time);
  EXPECT_GT(own.path, rival.path);  // over rough ground the tripod that waits is slower
  EXPECT_EQ(rival.scene, 2U);
  EXPECT_EQ(rival.flags & PoseFrame::tripod, PoseFrame::tripod);
  EXPECT_EQ(own.flags & PoseFrame::tripod, 0);
  EXPECT_THAT(session.receive(client, R"({"type":"reset"})"), IsEmpty());
  EXPECT_THAT(setup_with(session, R"("race":null)"), HasSubstr(R"("scene":3)"));
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
}  // namespace hexagait::viewer::session_test
