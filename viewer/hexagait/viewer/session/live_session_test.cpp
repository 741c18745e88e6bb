// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cmath>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/pipe/pipe_robot.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/viewer/session/session.hpp>
#include <nlohmann/json.hpp>
#include <numbers>
#include <testing/argos_walk.hpp>

// A live robot: here the test itself, at the far end of the pipe. It sends one state after the other and
// looks at the targets that come back, so ticks are counted, whatever the machine does.
namespace hexagait::viewer {
namespace {

using std::chrono::milliseconds;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kPeriod = 0.002;
constexpr const char* kStop = R"({"type":"estop"})";
constexpr const char* kRelease = R"({"type":"release_estop"})";
constexpr const char* kAhead = R"({"type":"drive","curvature":0})";

// Its joints are where the last targets wanted them, and its feet touch the ground where they are lowest.
class Robot {
 public:
  Robot(int socket, const RobotModel& model)
      : model_(model), pipe_(socket, socket, size_of(model)) {
    state.q = LegArray<LegJoints>(model.num_legs());
    state.contact = LegArray<bool>(model.num_legs(), true);
    for (LegId i = 0; i < model.num_legs(); ++i)
      state.q[i] = inverse_kinematics(model.legs[i], model.legs[i].p_BC).q;
  }

  // One control period. @returns false if there are no targets
  bool live() {
    EXPECT_TRUE(pipe_.send(state));
    if (pipe_.receive(2.0) != PipeRobot::Heard::targets) return false;
    state.time += kPeriod;
    state.q = pipe_.targets().q;
    double lowest = 0.0;
    for (LegId i = 0; i < model_.num_legs(); ++i)
      lowest = std::min(lowest, foot_position(model_.legs[i], state.q[i]).z());
    for (LegId i = 0; i < model_.num_legs(); ++i)
      state.contact[i] = foot_position(model_.legs[i], state.q[i]).z() < lowest + 0.005;
    return true;
  }
  void live(double seconds) {
    for (long k = std::lround(seconds / kPeriod); k > 0; --k) ASSERT_TRUE(live());
  }

  [[nodiscard]] bool stopped() const { return pipe_.stopped(); }
  // The fastest joint of the last targets [rad/s].
  [[nodiscard]] double speed() const {
    double fastest = 0.0;
    for (const LegJoints& qd : pipe_.targets().qd)
      fastest = std::max(fastest, qd.cwiseAbs().maxCoeff());
    return fastest;
  }
  PipeRobot& pipe() { return pipe_; }

  Measurement state;

 private:
  const RobotModel& model_;
  PipeRobot pipe_;
};

class LiveSession : public ::testing::Test {
 protected:
  LiveSession()
      : model_(testing::argos()),
        ends_(make()),
        plant_(ends_[0], model_, kPeriod),
        robot_(ends_[1], model_) {}
  ~LiveSession() override {
    session_.reset();
    hang_up();
    ::close(ends_[0]);
  }

  static std::array<int, 2> make() {
    std::array<int, 2> ends{};
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_SEQPACKET, 0, ends.data()), 0);
    return ends;
  }
  void hang_up() {
    if (ends_[1] >= 0) ::close(std::exchange(ends_[1], -1));
  }

  SessionOptions options() {
    SessionOptions result;
    result.robot = model_;
    result.live = &plant_;
    result.simulation.late_limit = 10.0;  // the machine may stop this process for a moment
    return result;
  }
  void start(heading_control::Heading heading = heading_control::Heading::stop()) {
    SessionOptions begin = options();
    begin.heading = heading;
    start(std::move(begin));
  }
  void start(SessionOptions begin) {
    ASSERT_TRUE(robot_.pipe().send(robot_.state));  // which it takes over
    session_ = std::make_unique<Session>(std::move(begin));
    ASSERT_EQ(robot_.pipe().receive(2.0), PipeRobot::Heard::targets);
  }

  std::string send(ClientId client, const std::string& message) {
    return session_->receive(client, message);
  }
  // It walks, as its first client says.
  void walk(ClientId client) {
    ASSERT_THAT(send(client, kAhead), IsEmpty());
    robot_.live(0.4);
    ASSERT_GT(robot_.speed(), 0.1);
  }

  template <class Wanted>
  std::string letter_when(Host::Mail kind, Wanted wanted) {
    std::string last = "none";
    for (int k = 0; k < 1000; ++k) {
      if (alive_) robot_.live(5 * kPeriod);  // states go on
      Host::Seen seen;
      Host::Letter letter;
      while (session_->newer_than(seen, letter))
        if (letter.kind == kind && wanted(last = letter.content)) return last;
      std::this_thread::sleep_for(milliseconds(3));
    }
    ADD_FAILURE() << "no such letter; the last one: " << last;
    return last;
  }
  std::string letter_with(Host::Mail kind, const std::string& text) {
    return letter_when(
        kind, [&](const std::string& content) { return content.find(text) != std::string::npos; });
  }
  template <class Wanted>
  PoseFrame frame_when(Wanted wanted) {
    return decode(letter_when(Host::Mail::frame,
                              [&](const std::string& bytes) { return wanted(decode(bytes)); }));
  }

  RobotModel model_;
  std::array<int, 2> ends_;
  PipePlant plant_;
  Robot robot_;
  std::unique_ptr<Session> session_;
  bool alive_ = true;
};

TEST_F(LiveSession, StandsUntilItIsSteered) {
  start();
  const ClientId client = session_->enter();
  robot_.live(0.5);
  EXPECT_LT(robot_.speed(), 0.05);
  EXPECT_FALSE(robot_.stopped());
  EXPECT_THAT(letter_with(Host::Mail::scene, "scene"), HasSubstr(R"("live":true)"));
  walk(client);
  frame_when([](const PoseFrame& f) { return f.path > 0.02; });
}

// The tick that takes the first state after the message has arrived holds all joints, and says so.
TEST_F(LiveSession, EmergencyStopOfAnybodyHoldsInTheNextTick) {
  start();
  const ClientId driver = session_->enter(), bystander = session_->enter();
  walk(driver);
  EXPECT_THAT(send(bystander, kAhead), HasSubstr("another page holds the wheel"));
  const LegArray<LegJoints> before = robot_.pipe().targets().q;
  EXPECT_THAT(send(bystander, kStop), IsEmpty());
  ASSERT_TRUE(robot_.live());
  EXPECT_TRUE(robot_.stopped());
  EXPECT_EQ(robot_.speed(), 0.0);
  for (LegId i = 0; i < model_.num_legs(); ++i)
    EXPECT_EQ(robot_.pipe().targets().q[i], before[i]) << "the set point that it had";
  robot_.live(0.1);
  EXPECT_TRUE(robot_.stopped());
  EXPECT_EQ(robot_.speed(), 0.0);
  EXPECT_THAT(letter_with(Host::Mail::setup, R"("estop":2)"), HasSubstr("setup"));
  frame_when([](const PoseFrame& f) { return f.fault == 5; });
}

TEST_F(LiveSession, OnlyTheHolderOfTheWheelReleasesTheStop) {
  start();
  const ClientId driver = session_->enter(), bystander = session_->enter();
  walk(driver);
  EXPECT_THAT(send(bystander, kStop), IsEmpty());
  robot_.live(0.05);
  EXPECT_THAT(send(bystander, kRelease), HasSubstr("another page holds the wheel"));
  EXPECT_THAT(send(driver, kAhead), HasSubstr("release it first"));
  robot_.live(0.05);
  EXPECT_TRUE(robot_.stopped());

  EXPECT_THAT(send(driver, kRelease), IsEmpty());
  ASSERT_TRUE(robot_.live());
  EXPECT_FALSE(robot_.stopped());
  letter_with(Host::Mail::setup, R"("estop":null)");
  frame_when([](const PoseFrame& f) { return f.fault == 0 && !f.moving; });
  robot_.live(3.0);  // legs that were in the air come down
  EXPECT_LT(robot_.speed(), 0.1) << "it stands until it is steered";
  walk(driver);
}

// It goes where it was: odometry begins anew, the picture does not.
TEST_F(LiveSession, IsSeenWhereItWasAfterAStop) {
  start();
  const ClientId client = session_->enter();
  walk(client);
  robot_.live(1.0);
  EXPECT_THAT(send(client, kStop), IsEmpty());
  robot_.live(0.1);
  const PoseFrame before = frame_when([](const PoseFrame& f) { return f.fault == 5; });
  ASSERT_GT(before.X_WB.p.x(), 0.05);
  EXPECT_THAT(send(client, kRelease), IsEmpty());
  robot_.live(0.1);
  const PoseFrame after = frame_when([](const PoseFrame& f) { return f.fault == 0; });
  EXPECT_LT((after.X_WB.p - before.X_WB.p).head<2>().norm(), 0.02);
}

// Who floods the session may still stop it, and what came before the stop does not count any more.
TEST_F(LiveSession, EmergencyStopPassesTheRateLimitAndTheQueue) {
  start();
  const ClientId driver = session_->enter(), flood = session_->enter();
  walk(driver);
  std::string answer;
  for (int k = 0; k < 1000 && answer.find("too many messages") == std::string::npos; ++k)
    answer = send(flood, R"({"type":"beat"})");
  ASSERT_THAT(answer, HasSubstr("too many messages"));
  EXPECT_THAT(send(driver, R"({"type":"gait","gait":"tripod"})"), IsEmpty());
  EXPECT_THAT(send(driver, kRelease), IsEmpty());
  EXPECT_THAT(send(flood, kStop), IsEmpty());
  robot_.live(0.05);
  EXPECT_TRUE(robot_.stopped());
}

TEST_F(LiveSession, StopsWhenItsHolderFallsSilent) {
  start();
  walk(session_->enter());
  const PoseFrame f =
      frame_when([](const PoseFrame& g) { return (g.flags & PoseFrame::silent) != 0; });
  EXPECT_FALSE(f.moving);
  EXPECT_FALSE(robot_.stopped()) << "it is told to stop, and is no emergency";
}

TEST_F(LiveSession, RefusesWhatNeedsASimulatedRobot) {
  start();
  const ClientId client = session_->enter();
  const char* const refused[] = {
      R"({"type":"pause","on":true})",         R"({"type":"step","ticks":1})",
      R"({"type":"speed","factor":2})",        R"({"type":"scramble"})",
      R"({"type":"push","angle":0})",          R"({"type":"race","on":true,"gait":"free"})",
      R"({"type":"fault","fault":"dead:LF"})", R"({"type":"mend"})",
      R"({"type":"plant","plant":"real"})",    R"({"type":"reset"})",
      R"({"type":"restart","seed":2})"};
  for (const char* const message : refused)
    EXPECT_THAT(send(client, message), HasSubstr("a live robot can't")) << message;
  EXPECT_EQ(session_->statistics().commands, 0U);
  robot_.live(0.1);
  EXPECT_EQ(frame_when([](const PoseFrame& f) { return f.scene > 0; }).holder, 0U);
  EXPECT_THAT(send(client, R"({"type":"gait","gait":"wave:0.75"})"), IsEmpty());
  robot_.live(0.1);
  frame_when([](const PoseFrame& f) { return (f.flags & PoseFrame::wave) != 0; });
}

// The body goes down, and then up, until the emergency stop holds it in the next tick.
TEST_F(LiveSession, PerformsAnActionAndIsHeldByAnEmergencyStop) {
  start();
  const ClientId client = session_->enter();
  const auto perform = [&](const std::string& height, const std::string& until) {
    EXPECT_THAT(
        send(client,
             R"({"type":"action","name":"move","yaml":"steps:\n- step:\n  - base_auto: {height: )" +
                 height + "}\"}"),
        IsEmpty());
    letter_when(Host::Mail::action, [&](const std::string& news) {
      EXPECT_THAT(send(client, R"({"type":"beat"})"), IsEmpty());
      return news.find(until) != std::string::npos;
    });
  };
  const auto foot = [&] { return foot_position(model_.legs[0], robot_.state.q[0]).z(); };
  perform("0.2", R"("state":"done")");
  EXPECT_NEAR(foot(), -0.2, 0.03);
  perform("0.22", R"("state":"running","step":1)");
  robot_.live(0.2);
  EXPECT_GT(robot_.speed(), 0.01);
  EXPECT_THAT(send(client, kStop), IsEmpty());
  ASSERT_TRUE(robot_.live());
  EXPECT_TRUE(robot_.stopped());
  EXPECT_EQ(robot_.speed(), 0.0);
}

TEST_F(LiveSession, TellsThatStatesWereLate) {
  start();
  robot_.live(0.05);
  alive_ = false;
  std::this_thread::sleep_for(milliseconds(300));  // longer than the limit is unless it is set
  while (robot_.pipe().receive(0.0) == PipeRobot::Heard::targets) {
  }
  frame_when(
      [](const PoseFrame& f) { return (f.flags & PoseFrame::holding) != 0 || f.fault != 0; });
  robot_.live(0.05);
  EXPECT_FALSE(robot_.stopped());
  letter_with(Host::Mail::notice, "no state of the robot for ");
}

// Silent for longer than the limit it is stopped, with what it hears; and it can be taken over again.
TEST_F(LiveSession, StopsARobotThatIsSilentAndCanTakeItOverAgain) {
  SessionOptions begin = options();
  begin.heading = heading_control::Heading::stop();
  begin.simulation.late_limit = 1.0;
  start(std::move(begin));
  const ClientId client = session_->enter();
  robot_.live(0.05);
  std::this_thread::sleep_for(milliseconds(400));
  while (robot_.pipe().receive(0.0) == PipeRobot::Heard::targets) {
  }
  alive_ = false;
  frame_when([](const PoseFrame& f) { return f.fault == static_cast<int>(Fault::plant_late); });
  robot_.live(0.05);
  EXPECT_TRUE(robot_.stopped());
  EXPECT_EQ(robot_.speed(), 0.0);
  EXPECT_THAT(send(client, kRelease), IsEmpty());
  robot_.live(0.05);
  EXPECT_FALSE(robot_.stopped());
}

// A measurement that is none stops it; as long as there is no other one it stays so.
TEST_F(LiveSession, IsNotReleasedWithoutAGoodMeasurement) {
  start();
  const ClientId client = session_->enter();
  robot_.live(0.05);
  const double good = robot_.state.q[2][1];
  robot_.state.q[2][1] = std::nan("");
  ASSERT_TRUE(robot_.live());
  ASSERT_TRUE(robot_.live());
  EXPECT_TRUE(robot_.stopped());
  robot_.state.q[2][1] = std::nan("");
  ASSERT_TRUE(robot_.live());
  EXPECT_THAT(send(client, kRelease), IsEmpty());
  robot_.state.q[2][1] = std::nan("");
  ASSERT_TRUE(robot_.live());
  alive_ = false;
  letter_with(Host::Mail::notice, "finite position");
  EXPECT_TRUE(robot_.stopped());
  robot_.state.q[2][1] = good;
  robot_.live(0.05);
  EXPECT_THAT(send(client, kRelease), IsEmpty());
  robot_.live(0.05);
  EXPECT_FALSE(robot_.stopped());
}

TEST_F(LiveSession, SaysWhyThePipeIsClosed) {
  start();
  robot_.live(0.05);
  alive_ = false;
  hang_up();
  letter_with(Host::Mail::notice, "the robot closed the pipe");
  frame_when([](const PoseFrame& f) { return f.fault == static_cast<int>(Fault::plant_closed); });
  EXPECT_EQ(session_->statistics().fault, Fault::plant_closed);
  const std::uint64_t ticks = session_->statistics().ticks;
  std::this_thread::sleep_for(milliseconds(100));
  EXPECT_EQ(session_->statistics().ticks, ticks) << "nothing more to do";
}

TEST_F(LiveSession, LeavesTheRobotStopped) {
  start();
  walk(session_->enter());
  session_.reset();
  ASSERT_EQ(robot_.pipe().receive(1.0), PipeRobot::Heard::targets);
  EXPECT_TRUE(robot_.stopped());
  EXPECT_EQ(robot_.speed(), 0.0);
}

TEST_F(LiveSession, RefusesARobotThatSaysNothingOrNonsense) {
  const auto refusal = [&] {
    SessionOptions begin = options();
    begin.live_patience = 0.1;
    try {
      const Session session(std::move(begin));
    } catch (const InvalidInput& error) {
      return std::string(error.what());
    }
    return std::string("it began");
  };
  EXPECT_EQ(refusal(), "the robot has sent no state for 0.1 s");
  const std::string text = "Hello\n";
  EXPECT_EQ(::send(ends_[1], text.data(), text.size(), 0), 6);
  EXPECT_THAT(refusal(), HasSubstr("the robot sent 6 bytes, beginning with \"Hello\""));
}

}  // namespace
}  // namespace hexagait::viewer
