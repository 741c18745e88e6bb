// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <hexagait/pipe/pipe_plant.hpp>
#include <hexagait/pipe/pipe_robot.hpp>
#include <testing/argos.hpp>

namespace hexagait {
namespace {

using testing::argos;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Clock = std::chrono::steady_clock;

constexpr double kPeriod = 0.002;

Measurement state_at(double time) {
  return {.time = time,
          .q = LegArray<LegJoints>(6, LegJoints::Constant(0.1 * time)),
          .contact = LegArray<bool>(6, true)};
}

// Both ends, in one thread.
class Pipe : public ::testing::Test {
 protected:
  Pipe()
      : ends_(make()),
        plant(ends_[0], argos(), kPeriod),
        robot(ends_[1], ends_[1], size_of(argos())) {}
  ~Pipe() override {
    for (const int end : ends_)
      if (end >= 0) ::close(end);
  }

  static std::array<int, 2> make() {
    std::array<int, 2> ends{};
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_SEQPACKET, 0, ends.data()), 0);
    return ends;
  }
  void hang_up(int end) { ::close(std::exchange(ends_[static_cast<std::size_t>(end)], -1)); }
  void send_text(const std::string& text) const {
    EXPECT_EQ(::send(ends_[1], text.data(), text.size(), 0), static_cast<ssize_t>(text.size()));
  }
  // How long a read takes that gets nothing [s].
  double wait() {
    const auto begin = Clock::now();
    EXPECT_EQ(plant.read(measurement), PlantStatus::late);
    return std::chrono::duration<double>(Clock::now() - begin).count();
  }

  std::array<int, 2> ends_;
  PipePlant plant;
  PipeRobot robot;
  Measurement measurement;
};

TEST_F(Pipe, BringsStatesThereAndTargetsBack) {
  ASSERT_TRUE(robot.send(state_at(3.0)));
  ASSERT_EQ(plant.read(measurement), PlantStatus::fresh);
  EXPECT_EQ(measurement.time, 3.0);
  EXPECT_EQ(measurement.q[5], state_at(3.0).q[5]);

  JointTargets targets{.q = measurement.q, .qd = measurement.q, .effort = measurement.q};
  plant.write(targets);
  ASSERT_EQ(robot.receive(0.1), PipeRobot::Heard::targets);
  EXPECT_EQ(robot.targets().qd[2], targets.qd[2]);
  EXPECT_FALSE(robot.stopped());
  plant.set_stopped(true);
  plant.write(targets);
  ASSERT_EQ(robot.receive(0.1), PipeRobot::Heard::targets);
  EXPECT_TRUE(robot.stopped());
  EXPECT_EQ(robot.receive(0.0), PipeRobot::Heard::nothing);
  EXPECT_THAT(plant.problem() + robot.problem(), IsEmpty());
}

// Who was away for a while goes on with what is true now.
TEST_F(Pipe, TakesTheNewestOfSeveral) {
  for (const double time : {1.0, 2.0, 3.0}) ASSERT_TRUE(robot.send(state_at(time)));
  ASSERT_EQ(plant.read(measurement), PlantStatus::fresh);
  EXPECT_EQ(measurement.time, 3.0);
  EXPECT_EQ(plant.read(measurement), PlantStatus::late);

  JointTargets targets{.q = measurement.q, .qd = measurement.q, .effort = measurement.q};
  plant.write(targets);
  targets.q[0].setConstant(7.0);
  plant.write(targets);
  ASSERT_EQ(robot.receive(0.1), PipeRobot::Heard::targets);
  EXPECT_EQ(robot.targets().q[0][0], 7.0);
  EXPECT_EQ(robot.receive(0.0), PipeRobot::Heard::nothing);
}

TEST_F(Pipe, WaitsForTheFirstStateAndThenAPeriodForEach) {
  EXPECT_GE(wait(), 0.9 * PipePlant::kPatience);
  double shortest = wait();
  EXPECT_GE(shortest, 0.9 * kPeriod);
  for (int k = 0; k < 20; ++k) shortest = std::min(shortest, wait());
  EXPECT_LT(shortest, 0.5 * PipePlant::kPatience);
  ASSERT_TRUE(robot.send(state_at(1.0)));
  EXPECT_EQ(plant.read(measurement), PlantStatus::fresh);
  EXPECT_GE(wait(), 0.9 * PipePlant::kPatience);  // in time again
}

TEST_F(Pipe, SaysThatTheRobotIsGoneAfterItsLastState) {
  ASSERT_TRUE(robot.send(state_at(1.0)));
  hang_up(1);
  EXPECT_EQ(plant.read(measurement), PlantStatus::fresh);
  EXPECT_EQ(plant.read(measurement), PlantStatus::closed);
  EXPECT_EQ(plant.problem(), "closed the pipe");
  plant.write({});
  EXPECT_EQ(plant.read(measurement), PlantStatus::closed);
}

TEST_F(Pipe, SaysThatTheControllerIsGone) {
  hang_up(0);
  EXPECT_EQ(robot.receive(0.1), PipeRobot::Heard::closed);
  EXPECT_FALSE(robot.send(state_at(1.0)));
  EXPECT_EQ(robot.problem(), "closed the pipe");
}

// Its last word is heard, although it left without reading what it was sent.
TEST_F(Pipe, BringsTheLastTargetsOfAControllerThatHasGone) {
  ASSERT_TRUE(robot.send(state_at(1.0)));
  plant.set_stopped(true);
  plant.write({.q = state_at(1.0).q, .qd = state_at(1.0).q, .effort = state_at(1.0).q});
  hang_up(0);
  EXPECT_FALSE(robot.send(state_at(2.0)));
  ASSERT_EQ(robot.receive(0.1), PipeRobot::Heard::targets);
  EXPECT_TRUE(robot.stopped());
  EXPECT_EQ(robot.receive(0.1), PipeRobot::Heard::closed);
}

TEST_F(Pipe, NamesWhatIsNoState) {
  send_text("Motors on\n");
  EXPECT_EQ(plant.read(measurement), PlantStatus::closed);
  EXPECT_THAT(plant.problem(), HasSubstr("sent 10 bytes, beginning with \"Motors o\""));
}

TEST_F(Pipe, NamesAnotherRobot) {
  PipeRobot other(ends_[1], ends_[1], {.legs = 4, .joints = 12});
  ASSERT_TRUE(other.send(state_at(1.0)));
  EXPECT_EQ(plant.read(measurement), PlantStatus::closed);
  EXPECT_THAT(plant.problem(), HasSubstr("4 legs and 12 joints"));
  PipePlant theirs(ends_[0], argos(), kPeriod);
  theirs.write({});
  EXPECT_EQ(other.receive(0.1), PipeRobot::Heard::closed);
  EXPECT_THAT(other.problem(), HasSubstr("6 legs and 18 joints"));
}

// A robot that reads nothing does not hold the controller up.
TEST_F(Pipe, NeverWaitsToWrite) {
  const auto begin = Clock::now();
  for (int k = 0; k < 5000; ++k) plant.write({});
  EXPECT_LT(std::chrono::duration<double>(Clock::now() - begin).count(), 5.0);
  EXPECT_THAT(plant.problem(), IsEmpty());
}

}  // namespace
}  // namespace hexagait
