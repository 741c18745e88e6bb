// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/text_file.hpp>
#include <hexagait/viewer/tasks/checked_action.hpp>
#include <testing/argos_walk.hpp>
#include <testing/source_path.hpp>

// Scripted actions of a robot that walks.
namespace hexagait::viewer {
namespace {

using heading_control::Heading;
using State = ActionProgress::State;
using testing::argos;
using testing::on;
using testing::run;

action::Action shared(const std::string& name) {
  const std::atomic<bool> cancelled = false;
  const std::string text =
      read_text(hexagait::testing::source_path("actions/" + name + ".yaml"), 100'000);
  CheckedAction checked = check_action(text, {argos(), {}, {}}, cancelled);
  EXPECT_TRUE(checked.action) << name << ": " << checked.why;
  return std::move(*checked.action);
}

void cut_off_rm(SimulatedWalk& walk) {
  walk.add(walk::resolved({walk::parse_part_fault("cut:RM")}, argos()).front());
}

// Told to walk on all the time. @returns how long it took [s]
template <class Until>
double run_until(SimulatedWalk& walk, Until until, double most = 60.0) {
  double time = 0.0;
  for (; time < most && !until(); time += walk.control_dt())
    walk.tick({Heading::straight(0.0), testing::kInfinite});
  EXPECT_LT(time, most);
  return time;
}
double perform(SimulatedWalk& walk) {
  return run_until(walk, [&] { return !walk.performs(); });
}

// By how much the joints differ, at most [rad].
double joint_distance(const PoseFrame& a, const PoseFrame& b) {
  double most = 0.0;
  for (LegId i = 0; i < a.legs.size(); ++i)
    most = std::max(most, (a.legs[i].q - b.legs[i].q).cwiseAbs().maxCoeff());
  return most;
}

// The body goes up and down on the spot while the robot is told to walk; then it walks.
TEST(Performance, OfAWalkingRobotThatWalksOnAfterwards) {
  for (const char* const terrain : {"flat", "boxes:0.05"}) {
    SimulatedWalk walk(argos(), on(terrain));
    run(walk, Heading::straight(0.0), 2.3);
    walk.perform(shared("height"));
    EXPECT_EQ(walk.progress().state, State::halting);
    run_until(walk, [&] { return walk.progress().state != State::halting; });
    ASSERT_EQ(walk.progress().state, State::running);
    const Vector3 where = walk.frame().X_WB.p;
    double lowest = where.z(), highest = where.z(), farthest = 0.0;
    const double time = run_until(walk, [&] {
      const Vector3 p = walk.frame().X_WB.p;
      lowest = std::min(lowest, p.z());
      highest = std::max(highest, p.z());
      farthest = std::max(farthest, (p - where).head<2>().norm());
      return !walk.performs();
    });
    EXPECT_GT(time, 0.3);
    EXPECT_GT(highest - lowest, 0.03) << terrain;
    EXPECT_LT(farthest, 0.1) << terrain;
    EXPECT_EQ(walk.progress().state, State::done) << walk.progress().why;
    EXPECT_EQ(walk.progress().step, walk.progress().steps);
    const Vector2 stood = walk.place().shift;
    run(walk, Heading::straight(0.0), 4.0);
    EXPECT_GT((walk.place().shift - stood).norm(), 0.3) << terrain;
    EXPECT_FALSE(walk.fell()) << terrain;
  }
}

// While the action waits for the robot to stand it is shown as it walks, then as the action has it: one
// picture after the other, without a leap.
TEST(Performance, IsSeenWithoutALeap) {
  SimulatedWalk walk(argos(), on("flat"));
  run(walk, Heading::straight(0.0), 2.0);
  walk.perform(shared("wave"));
  PoseFrame last = walk.frame();
  std::uint32_t ticks = last.tick;
  bool lifted = false;
  for (int k = 0; walk.performs() && k < 30000; ++k) {
    walk.tick({Heading::straight(0.0), testing::kInfinite});
    const PoseFrame f = walk.frame();
    EXPECT_EQ(f.tick, ++ticks);
    EXPECT_LT(joint_distance(f, last), 0.05);
    EXPECT_LT((f.X_WB.p - last.X_WB.p).norm(), 0.005);
    for (const LegFrame& leg : f.legs) {
      if (!leg.p_WT.allFinite()) continue;
      EXPECT_LT((leg.p_WT - leg.p_WF).norm(), 0.5);
    }
    lifted = lifted || (walk.progress().state == State::running && !f.support.contains(1));
    last = f;
  }
  EXPECT_TRUE(lifted);
  EXPECT_EQ(walk.progress().state, State::done);
}

// With a leg that the action holds in the air: it comes down.
TEST(Performance, StopsInTheMiddleWithItsFeetOnTheGround) {
  SimulatedWalk walk(argos(), on("flat"));
  walk.perform(shared("paw"));
  run_until(walk, [&] { return walk.progress().step >= 3; });
  EXPECT_FALSE(walk.frame().contact.contains(1));
  walk.stop_action();
  EXPECT_LT(perform(walk), 5.0);
  EXPECT_EQ(walk.progress().state, State::stopped);
  double time = 0.0;  // in which the walker has the foot find the ground
  for (; time < 10.0 && walk.frame().contact != LegSet::all(6); time += 0.1)
    run(walk, Heading::stop(), 0.1);
  EXPECT_LT(time, 10.0);
  const double before = walk.frame().path;
  run(walk, Heading::straight(0.0), 4.0);
  EXPECT_GT(walk.frame().path, before + 0.3);
  EXPECT_FALSE(walk.fell());
}

TEST(Performance, StopsInTheTickInWhichItBegins) {
  SimulatedWalk walk(argos(), on("flat"));
  walk.perform(shared("paw"));
  walk.stop_action();
  walk.tick({Heading::stop(), testing::kInfinite});
  EXPECT_EQ(walk.progress().state, State::stopped);
  walk.perform(shared("paw"));
  run_until(walk, [&] { return walk.progress().state == State::running; });
  walk.stop_action();
  EXPECT_LT(perform(walk), 1.0);
  EXPECT_EQ(walk.progress().state, State::stopped);
}

TEST(Performance, IsHeldByAnEmergencyStop) {
  SimulatedWalk walk(argos(), on("flat"));
  walk.perform(shared("paw"));
  run_until(walk, [&] { return walk.progress().step >= 3; });
  const LegArray<LegJoints> before = walk.targets().q;
  walk.emergency_stop();
  EXPECT_EQ(walk.fault(), Fault::emergency_stop);
  EXPECT_EQ(walk.progress().state, State::stopped);
  run(walk, Heading::straight(0.0), 1.0);
  for (LegId i = 0; i < 6; ++i) {
    EXPECT_TRUE(walk.targets().qd[i].isZero());
    EXPECT_EQ(walk.targets().q[i], before[i]);
  }
  EXPECT_FALSE(walk.frame().contact.contains(1));  // also the leg in the air
  EXPECT_EQ(walk.frame().fault, static_cast<std::uint8_t>(Fault::emergency_stop));
  EXPECT_THROW(walk.perform(shared("wave")), InvalidInput);

  walk.go_on();
  EXPECT_EQ(walk.fault(), Fault::none);
  run(walk, Heading::straight(0.0), 5.0);
  EXPECT_GT(walk.frame().path, 0.3);
  EXPECT_FALSE(walk.fell());
}

// The same while the robot comes to a stand for it.
TEST(Performance, IsHeldByAnEmergencyStopBeforeItBegins) {
  SimulatedWalk walk(argos(), on("flat"));
  run(walk, Heading::straight(0.0), 2.0);
  walk.perform(shared("paw"));
  walk.emergency_stop();
  run(walk, Heading::straight(0.0), 0.5);
  for (const LegJoints& qd : walk.targets().qd) EXPECT_TRUE(qd.isZero());
  EXPECT_EQ(walk.progress().state, State::stopped);
  walk.go_on();
  run(walk, Heading::straight(0.0), 4.0);
  EXPECT_GT(walk.frame().path, 0.3);
}

// Its belly on the ground is no fall, and the walker raises it again.
TEST(Performance, SitsDownAndStandsUpToWalk) {
  SimulatedWalk walk(argos(), on("flat"));
  const double height = walk.frame().X_WB.p.z();
  walk.perform(shared("sit_down"));
  perform(walk);
  EXPECT_EQ(walk.progress().state, State::done) << walk.progress().why;
  EXPECT_LT(walk.frame().X_WB.p.z(), 0.5 * height);
  EXPECT_FALSE(walk.fell());
  run(walk, Heading::straight(0.0), 8.0);
  EXPECT_FALSE(walk.fell());
  EXPECT_NEAR(walk.frame().X_WB.p.z(), height, 0.03);
  EXPECT_GT(walk.frame().path, 0.3);
}

TEST(Performance, IsRefusedOfARobotThatCantAndWhileOneGoesOn) {
  SimulatedWalk walk(argos(), on("flat"));
  walk.perform(shared("wave"));
  EXPECT_THROW(walk.perform(shared("wave")), InvalidInput);
  SimulatedWalk five(argos(), on("flat"));
  cut_off_rm(five);
  run(five, Heading::straight(0.0), 6.0);
  ASSERT_EQ(five.frame().legs[3].phase, kLost);
  EXPECT_THROW(five.perform(shared("wave")), InvalidInput);
}

// A leg is cut off in the same moment: the robot waits for it, and walks on with five.
TEST(Performance, FailsOfARobotThatDoesNotComeToAStand) {
  SimulatedWalk walk(argos(), on("flat"));
  run(walk, Heading::straight(0.0), 2.0);
  cut_off_rm(walk);
  walk.perform(shared("wave"));
  perform(walk);
  EXPECT_EQ(walk.progress().state, State::failed);
  EXPECT_STREQ(walk.progress().why, "the robot does not come to stand on all its feet");
  const Vector2 stood = walk.place().shift;
  run(walk, Heading::straight(0.0), 4.0);
  EXPECT_GT((walk.place().shift - stood).norm(), 0.2);
}

}  // namespace
}  // namespace hexagait::viewer
