// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/text/invalid_input.hpp>
#include <hexagait/viewer/session/session.hpp>
#include <testing/argos_walk.hpp>
#include <testing/session_client.hpp>

// The emergency stop of a simulated robot.
namespace hexagait::viewer {
namespace {

using heading_control::Heading;
using testing::argos;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::on;
using testing::run;

// Whichever legs are in the air: held, let go, standing, walking on.
TEST(EmergencyStop, HoldsAndGoesOnInEveryPhaseOfTheStep) {
  for (int k = 0; k < 6; ++k) {
    const char* const terrain = k % 2 == 0 ? "flat" : "boxes:0.05";
    SimulatedWalk walk(argos(), on(terrain));
    run(walk, Heading::straight(0.0), 2.0 + 0.13 * k);
    walk.emergency_stop();
    run(walk, Heading::straight(0.0), 0.5);
    for (const LegJoints& qd : walk.targets().qd) EXPECT_TRUE(qd.isZero());
    EXPECT_EQ(walk.fault(), Fault::emergency_stop);
    const Vector2 before = walk.place().shift;
    run(walk, Heading::straight(0.0), 0.5);
    EXPECT_LT((walk.place().shift - before).norm(), 0.005);

    walk.go_on();
    run(walk, Heading::stop(), 2.0);
    // The body goes to the middle of the feet.
    EXPECT_LT((walk.place().shift - before).norm(), 0.8 * walk.step().stroke) << terrain << k;
    EXPECT_LT(walk.frame().velocity.v.norm(), 0.01) << terrain << k;
    run(walk, Heading::straight(0.0), 3.0);
    EXPECT_FALSE(walk.fell()) << terrain << k;
    EXPECT_GT((walk.place().shift - before).norm(), 0.2) << terrain << k;
  }
}

TEST(EmergencyStop, IsNotReleasedForARobotThatLies) {
  SimulatedWalk walk(argos(), on("flat"));
  walk.emergency_stop();
  EXPECT_NO_THROW(walk.go_on());
  std::vector<walk::PartFault> legs;
  for (const char* const leg : {"cut:LF", "cut:LM", "cut:LR"})
    legs.push_back(walk::parse_part_fault(leg));
  for (const walk::PartFault& fault : resolved(legs, argos())) walk.add(fault);
  for (int k = 0; k < 20 && !walk.fell(); ++k) run(walk, Heading::straight(0.0), 0.2);
  ASSERT_TRUE(walk.fell());
  EXPECT_EQ(walk.fault(), Fault::emergency_stop);
  EXPECT_THROW(walk.go_on(), InvalidInput);
}

class StoppedSession : public ::testing::Test {
 protected:
  static SessionOptions options() {
    SessionOptions result;
    result.robot = argos();
    result.simulation = on("flat");
    result.heading = Heading::straight(0.0);
    return result;
  }
  template <class Wanted>
  PoseFrame frame_when(Wanted wanted) {
    return beats_ != 0 ? testing::held_until(session_, beats_, wanted, &setup_)
                       : testing::frame_when(session_, wanted, &setup_);
  }
  static bool held(const PoseFrame& f) { return f.fault == 5 && !(f.flags & PoseFrame::fell); }

  Session session_{options()};
  std::string setup_;
  ClientId beats_ = 0;  // who gives signs of life
};

// In simulation too, also while it is paused; and over a new scene until it is released.
TEST_F(StoppedSession, LastsUntilItIsReleased) {
  const ClientId driver = session_.enter(), bystander = session_.enter();
  EXPECT_THAT(session_.receive(driver, R"({"type":"pause","on":true})"), IsEmpty());
  EXPECT_THAT(session_.receive(bystander, R"({"type":"estop"})"), IsEmpty());
  frame_when(held);
  EXPECT_THAT(setup_, HasSubstr(R"("estop":2)"));
  EXPECT_THAT(session_.receive(driver, R"({"type":"spin","turn":"cw"})"),
              HasSubstr("the emergency stop holds the robot; release it first"));
  EXPECT_THAT(session_.receive(driver, R"({"type":"reset"})"), IsEmpty());
  const PoseFrame anew = frame_when([](const PoseFrame& f) { return f.scene == 2; });
  EXPECT_TRUE(held(anew));
  EXPECT_THAT(setup_, HasSubstr(R"("scene":2)"));
  EXPECT_THAT(setup_, HasSubstr(R"("estop":2)"));
  EXPECT_THAT(session_.receive(bystander, R"({"type":"release_estop"})"),
              HasSubstr("another page holds the wheel"));
  EXPECT_THAT(session_.receive(driver, R"({"type":"release_estop"})"), IsEmpty());
  frame_when([](const PoseFrame& f) { return f.fault == 0 && !f.moving; });
  EXPECT_THAT(setup_, HasSubstr(R"("estop":null)"));
  EXPECT_THAT(session_.receive(driver, R"({"type":"drive","curvature":0})"), IsEmpty());
  frame_when([](const PoseFrame& f) { return f.moving; });
  EXPECT_LE(session_.statistics().worst_delay, 1);
}

// Both robots of a race, and the path that was followed is left.
TEST_F(StoppedSession, HoldsARaceAndLeavesThePath) {
  const ClientId client = beats_ = session_.enter();
  EXPECT_THAT(session_.receive(client, R"({"type":"race","on":true,"gait":"tripod"})"), IsEmpty());
  EXPECT_THAT(session_.receive(client, R"({"type":"follow","points":[[0,0],[5,0]]})"), IsEmpty());
  frame_when([](const PoseFrame& f) { return (f.flags & PoseFrame::follows) != 0; });
  EXPECT_THAT(session_.receive(client, R"({"type":"estop"})"), IsEmpty());
  const PoseFrame f = frame_when(held);
  EXPECT_FALSE(f.flags & PoseFrame::follows);
  EXPECT_THAT(setup_, HasSubstr(R"("path":null)"));
  Session::Seen seen;
  Session::Letter letter;
  do {
    ASSERT_TRUE(session_.newer_than(seen, letter));
  } while (letter.kind != Session::Mail::frame);
  std::string_view frames = letter.content;
  EXPECT_EQ(decode_front(frames).fault, 5);
  EXPECT_EQ(decode_front(frames).fault, 5);
}

}  // namespace
}  // namespace hexagait::viewer
