// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdlib>
#include <hexagait/core/random.hpp>
#include <testing/counted_allocations.hpp>
#include <testing/scripted_robot.hpp>

// Whatever is commanded when, and whatever feet feel: laws that hold in every tick, of random
// actions that are preempted, replaced, paused and stopped on ground that comes and goes. More of
// them: RC_PARAMS="max_success=100000" core_test --gtest_filter='RandomActions.*'

namespace hexagait {
namespace {

using testing::ScriptedRobot;
using Touch = ScriptedRobot::Touch;

// Rapidcheck shrinks these small numbers; from them a fixed random sequence makes commands.
struct CommandSpec {
  int kind = 0, leg = 0, frame = 0, flags = 0, seed = 0;
};
using StepSpec = std::vector<CommandSpec>;
using ActionSpec = std::vector<StepSpec>;
struct EventSpec {
  int tick = 0, kind = 0, leg = 0, length = 0;
};
struct Spec {
  int robot = 0, params = 0, ground = 0;
  ActionSpec action, other;
  std::vector<EventSpec> events;
};

std::ostream& operator<<(std::ostream& os, const CommandSpec& c) {
  return os << '{' << c.kind << ',' << c.leg << ',' << c.frame << ',' << c.flags << ',' << c.seed
            << '}';
}
std::ostream& operator<<(std::ostream& os, const EventSpec& e) {
  return os << '{' << e.tick << ',' << e.kind << ',' << e.leg << ',' << e.length << '}';
}
template <class T>
std::ostream& operator<<(std::ostream& os, const std::vector<T>& list) {
  os << '{';
  for (const T& item : list) os << item << ',';
  return os << '}';
}
std::ostream& operator<<(std::ostream& os, const Spec& s) {
  return os << '{' << s.robot << ',' << s.params << ',' << s.ground << ',' << s.action << ','
            << s.other << ',' << s.events << '}';
}

RobotModel robot(const char* name) {
  return load_urdf(std::string(HEXAGAIT_SOURCE_DIR "/robots/") + name);
}
const RobotModel& robot(int index) {
  static const RobotModel robots[] = {robot("argos.urdf"), robot("quadruped.urdf")};
  return robots[index];
}

// Makes commands of specifications: values as a user may write them, now and then absurd ones.
class Writer {
 public:
  explicit Writer(const RobotModel& model) : model_(model) {}

  action::Action action(const ActionSpec& spec) {
    action::Action action;
    for (const StepSpec& step : spec) action.steps.push_back(this->step(step));
    if (!spec.empty() && !spec[0].empty() && spec[0][0].flags == 7)
      action.adapt_coordinates.push_back({kFootprint, kMap, pose(0.05), spec[0][0].leg % 2 == 0});
    return action;
  }

 private:
  action::Step step(const StepSpec& spec) {
    action::Step step;
    LegSet moved;
    for (const CommandSpec& command : spec) {
      random_ = {.seed = static_cast<std::uint64_t>(command.seed)};
      command_ = command;
      const LegId leg = command.leg % model_.num_legs();
      if (command.kind < 6 && !moved.contains(leg)) step.legs.push_back({leg_command(leg), {}});
      if (command.kind < 6) moved.insert(leg);
      if (command.kind >= 6 && command.kind < 10) step.base = {base_command(), {}};
      if (command.kind == 10) step.wait.duration = random_.uniform(0.0, 0.2);
      if (command.kind == 11) step.custom.push_back({0, "sound", random_.uniform(0.0, 0.2), "x"});
    }
    return step;
  }

  Vector3 vector(double size) {
    const double x = random_.uniform(-size, size), y = random_.uniform(-size, size);
    return {x, y, random_.uniform(-size, size)};
  }
  Pose pose(double size) { return {rotation(vector(size)), vector(size)}; }
  FrameId frame() const { return static_cast<FrameId>(command_.frame); }

  // A place of the foot near its nominal one, whatever the frame; rarely far from everything.
  Vector3 place(LegId leg, FrameId frame) {
    const bool in_body = frame == kBase || frame == kFirstRegistered;
    Vector3 p = model_.legs[leg].p_BC + vector(command_.flags == 6 ? 1.0 : 0.06);
    if (!in_body) p.z() = model_.foot_radius + random_.uniform(-0.03, 0.05);
    return p;
  }

  action::LegMotion motion(LegId leg) {
    action::LegMotion motion;
    motion.leg = leg;
    motion.ignore_contact = command_.flags % 4 == 1;
    motion.ignore_for_pose_adaptation = command_.flags % 4 == 2;
    if (command_.flags == 3) motion.surface_normal = {frame(), Vector3::UnitZ() + vector(0.5)};
    return motion;
  }

  decltype(action::LegCommand::motion) leg_command(LegId leg) {
    switch (command_.kind) {
      case 0: {
        action::Footstep step{motion(leg), {frame(), place(leg, frame())}};
        step.profile_height = random_.uniform(0.0, 0.12);
        step.profile = static_cast<SwingProfile>(command_.seed % 4);
        return step;
      }
      case 1: {
        action::EndEffectorTarget target{motion(leg), {frame(), place(leg, frame())}};
        if (command_.seed % 2 == 0) target.velocity = vector(0.2);
        if (command_.seed % 3 == 0) target.force = vector(30.0);
        return target;
      }
      case 2:
        return foot_trajectory(leg);
      case 3:
        return action::JointTarget{motion(leg), joint_knot(leg), 1.0};
      case 4:
        return joint_trajectory(leg);
      default:
        return action::LegMode{motion(leg), command_.flags % 2 == 0, random_.uniform(0.0, 0.3)};
    }
  }

  action::EndEffectorTrajectory foot_trajectory(LegId leg) {
    action::EndEffectorTrajectory trajectory{motion(leg), frame(), {}};
    double time = command_.seed % 2 * random_.uniform(0.0, 0.3);
    for (int k = 0; k <= command_.seed % 4; ++k) {
      trajectory.knots.push_back({time, place(leg, frame()), {}});
      if (command_.flags >= 4) trajectory.knots.back().v = vector(0.3);
      time += random_.uniform(0.002, 0.3);
    }
    return trajectory;
  }

  LegJoints joints(double size) {
    const Vector3 v = vector(size);
    return leg_joints({v.x(), v.y(), v.z()});
  }

  // Positions, velocities or efforts, or any of them for some of the joints.
  JointKnot joint_knot(LegId leg) {
    JointKnot knot;
    const LegJoints q = inverse_kinematics(model_.legs[leg], model_.legs[leg].p_BC).q;
    const int given = command_.seed % 8;
    if (given == 0 || given & 1) knot.q = q + joints(0.3);
    if (given & 2) knot.qd = joints(0.5);
    if (given & 4) knot.effort = joints(20.0);
    if (given == 7) knot.q[command_.seed % 3] = knot.qd[2] = JointKnot::kNone;
    return knot;
  }

  action::JointTrajectory joint_trajectory(LegId leg) {
    action::JointTrajectory trajectory{motion(leg), {}};
    double time = 0.0;
    for (int k = 0; k <= command_.flags % 4; ++k) {
      trajectory.knots.push_back(joint_knot(leg));
      trajectory.knots.back().time = time += random_.uniform(0.002, 0.3);
    }
    return trajectory;
  }

  // A pose of the base near where it stands.
  Pose base_pose() {
    Pose X = pose(0.05);
    const bool in_body = frame() == kBase || frame() == kFirstRegistered;
    if (!in_body) X.p.z() += model_.foot_radius - model_.legs[0].p_BC.z();
    return X;
  }

  decltype(action::BaseCommand::motion) base_command() {
    const bool ignores = command_.flags % 2 == 1;
    if (command_.kind == 6) {
      action::BaseAuto automatic;
      automatic.ignore_timing_of_leg_motion = ignores;
      if (command_.flags > 4) automatic.height = random_.uniform(0.2, 0.6);
      automatic.support_margin = random_.uniform(0.0, 0.08);
      return automatic;
    }
    if (command_.kind < 9) return action::BaseTarget{frame(), base_pose(), ignores, 0.1, 0.2};
    action::BaseTrajectory trajectory{frame(), {}};
    double time = 0.0;
    for (int k = 0; k <= command_.flags % 4; ++k) {
      trajectory.knots.push_back({time, base_pose()});
      time += random_.uniform(0.1, 0.4);
    }
    return trajectory;
  }

  const RobotModel& model_;
  RandomSequence random_;
  CommandSpec command_;
};

// Plays a specification and holds every tick to the laws.
class Play {
 public:
  explicit Play(const Spec& spec)
      : spec_(spec),
        model_(robot(spec.robot)),
        robot_(model_, params(spec.params)),
        writer_(model_),
        silent_(model_.num_legs(), 0),
        airborne_(model_.num_legs(), false) {
    robot_.ground = [this](double x, double y) { return ground(x, y); };
    robot_.runner.frames().registered[kFirstRegistered] = {kBase,
                                                           {rotation_z(0.2), Vector3::Zero()}};
    robot_.runner.frames().registered[kFirstRegistered + 1] = {kMap,
                                                               {rotation_z(-0.1), Vector3::Zero()}};
    robot_.runner.submit(writer_.action(spec.action));
  }

  void operator()() {
    for (int k = 0; k < 100'000; ++k) {
      begin_events(k);
      sense();
      tick(k % 97 == 96 && (spec_.params & 8) ? PlantStatus::late : PlantStatus::fresh);
      if (robot_.runner.idle() && k > last_event()) return judge_results();
    }
    RC_FAIL("no result");
  }

 private:
  static RunnerParams params(int bits) {
    RunnerParams params;
    if (bits % 8 == 7) params.executor.controller = WholeBodyController::virtual_model;
    if (bits % 8 == 6) params.sensors.foot_contacts = false;
    if (bits % 8 == 5) params.sensors.joint_feedback = false;
    return params;
  }

  double ground(double x, double y) const {
    if (spec_.ground == 1) return 0.02 * std::sin(20.0 * x) + 0.02 * std::sin(23.0 * y);
    if (spec_.ground == 2) return x > 0.1 ? -10.0 : 0.0;  // a precipice
    return 0.0;
  }

  int last_event() const {
    int last = 0;
    for (const EventSpec& event : spec_.events) last = std::max(last, event.tick + ticks(event));
    return last;
  }

  // Flickering may last as long as it takes to be given up.
  static int ticks(const EventSpec& event) {
    return event.kind == 2 && event.leg == 5 ? 100 * event.length : event.length;
  }

  void begin_events(int k) {
    robot_.touch = LegArray<Touch>(model_.num_legs(), Touch::as_the_ground_is);
    noise_ = 0.0;
    for (const EventSpec& event : spec_.events) {
      const int since = k - event.tick;
      if (since >= 0 && since <= ticks(event)) during(event, since);
      if (since == 0) at_once(event);
      if (since == event.length && event.kind == 6) robot_.runner.resume();
    }
  }

  void during(const EventSpec& event, int since) {
    const LegId leg = event.leg % model_.num_legs();
    if (event.kind == 0) robot_.touch[leg] = Touch::nothing;
    if (event.kind == 1) robot_.touch[leg] = Touch::something;
    if (event.kind == 2) robot_.touch[leg] = since % 3 == 0 ? Touch::something : Touch::nothing;
    if (event.kind == 3) noise_ = 1e-3;
    if (event.kind == 4) robot_.touch = LegArray<Touch>(model_.num_legs(), Touch::nothing);
  }

  void at_once(const EventSpec& event) {
    ActionRunner& runner = robot_.runner;
    const auto when = static_cast<Preemption>(event.leg % 3);
    if (event.kind == 5) submit(when);
    if (event.kind == 6) runner.pause();
    if (event.kind == 7) runner.stop(when);
    if (event.kind == 8) runner.replace(writer_.action(spec_.other).steps);
    if (event.kind == 9)
      runner.frames().X_OM = {rotation_z(0.01 * event.leg), Vector3(0.003 * event.length, 0, 0)};
  }

  void submit(Preemption when) { robot_.runner.submit(writer_.action(spec_.other), when); }

  void sense() {
    robot_.sense();
    for (LegJoints& q : robot_.measurement.q)
      for (int k = 0; k < 3; ++k) q[k] += random_.uniform(-noise_, noise_);
  }

  void tick(PlantStatus status) {
    const JointTargets before = robot_.record().desired.targets;
    const long allocations = testing::allocations;
    const ActionRecord& record = robot_.runner.tick(status, robot_.measurement);
    const bool allocated = testing::allocations != allocations;
    RC_ASSERT(!allocated);
    judge_numbers(record);
    judge_joints(before, record.desired.targets);
    if (status == PlantStatus::fresh) judge_support(record);
    judge_time(record);
  }

  void judge_numbers(const ActionRecord& record) const {
    const JointTargets& targets = record.desired.targets;
    for (LegId i = 0; i < targets.q.size(); ++i) {
      RC_ASSERT(targets.q[i].allFinite() && targets.qd[i].allFinite());
      RC_ASSERT(within_limits(model_.legs[i], targets.q[i]));
      RC_ASSERT(targets.effort[i].allFinite() && record.desired.normal_O[i].allFinite());
      const LegLane& lane = record.legs[i];
      RC_ASSERT(lane.p_BF.allFinite() && lane.v_O.allFinite() && lane.a_O.allFinite());
    }
    RC_ASSERT(!std::isnan(record.margin) && std::isfinite(record.feedback.phase));
    for (const Pose& X : {record.state.X_OB, record.desired.X_OB})
      RC_ASSERT(X.R.allFinite() && X.p.allFinite());
    for (const Twist& V : {record.state.V_B, record.desired.V_B})
      RC_ASSERT(V.v.allFinite() && V.w.allFinite());
  }

  void judge_joints(const JointTargets& before, const JointTargets& now) const {
    for (LegId i = 0; i < model_.num_legs(); ++i)
      for (int k = 0; k < 3 && before.mode[i] == now.mode[i]; ++k) {
        const double velocity = model_.legs[i].limits[k].velocity;
        RC_ASSERT(std::abs(now.q[i][k] - before.q[i][k]) <= velocity * robot_.dt() * (1.0 + 1e-9));
      }
  }

  // Support without contact, and support of what has not come down.
  void judge_support(const ActionRecord& record) {
    const SwingParams& swing = robot_.runner.executor().params().swing;
    if (!robot_.runner.params().sensors.foot_contacts) return;
    for (LegId i = 0; i < model_.num_legs(); ++i) {
      const bool contact = robot_.measurement.contact[i];
      silent_[i] = contact ? 0 : silent_[i] + 1;
      airborne_[i] = !contact && (airborne_[i] || !record.legs[i].on_ground());
      const bool gives_up = record.legs[i].exhausted && record.legs[i].phase == LegPhase::hold;
      RC_ASSERT(!contact || !gives_up || record.legs[i].time > 0.0 || !executor_reaches(i));
      if (!record.desired.support.contains(i)) continue;
      RC_ASSERT(silent_[i] * robot_.dt() <= swing.lost_time + robot_.dt());
      RC_ASSERT(!airborne_[i]);
    }
  }

  bool executor_reaches(LegId leg) const { return robot_.runner.executor().reachable(leg); }

  // A step lasts as long as was planned, and in addition at most: pauses, load transfer; one search
  // for the ground, then all that counts as regaining contact; a stop at most three searches.
  void judge_time(const ActionRecord& record) {
    const bool same = record.feedback.action == action_ && record.feedback.step == step_;
    action_ = record.feedback.action;
    step_ = record.feedback.step;
    const bool stops = record.feedback.status == ActionStatus::stopping;
    if (!same) time_ = stop_ = 0.0;
    if (step_ == 0) return;
    if (record.feedback.status != ActionStatus::paused) (stops ? stop_ : time_) += robot_.dt();
    const RunnerParams& params = robot_.runner.params();
    const SwingParams& swing = params.executor.swing;
    const double late = 1.03 * (record.feedback.duration + params.sequencer.regain_limit);
    RC_ASSERT(time_ <= late + swing.unload_time + swing.search_time +
                           4.0 * params.sequencer.pause_time + 0.1);
    RC_ASSERT(stop_ <= 3.0 * swing.search_time + 0.1);
  }

  void judge_results() {
    const ActionRecord& record = robot_.record();
    RC_ASSERT(record.result.action == record.feedback.action);
    RC_ASSERT(record.result.action >= 1U);
    RC_ASSERT(record.result.outcome != Outcome::none);
    RC_ASSERT((record.result.outcome == Outcome::failed) == (record.result.cause != Cause::none));
    RC_CLASSIFY(record.result.outcome == Outcome::succeeded, "succeeded");
    RC_CLASSIFY(record.result.outcome == Outcome::preempted, "preempted");
    RC_CLASSIFY(record.result.outcome == Outcome::failed, to_string(record.result.cause));
  }

  const Spec& spec_;
  const RobotModel& model_;
  ScriptedRobot robot_;
  Writer writer_;
  RandomSequence random_{.seed = 7, .stream = RandomStream::noise};
  double noise_ = 0.0;
  LegArray<int> silent_;     ///< ticks without contact
  LegArray<bool> airborne_;  ///< has left the ground and not touched since
  std::uint64_t action_ = 0;
  int step_ = 0;
  double time_ = 0.0, stop_ = 0.0;
};

rc::Gen<CommandSpec> command_specs() {
  using rc::gen::inRange;
  return rc::gen::construct<CommandSpec>(inRange(0, 12), inRange(0, 6), inRange(0, 6),
                                         inRange(0, 8), inRange(0, 1000));
}

// Some of something: size grows with the number of the trial otherwise.
template <class T>
rc::Gen<std::vector<T>> few(int least, int most, rc::Gen<T> gen) {
  return rc::gen::mapcat(rc::gen::inRange(least, most + 1), [gen](int n) {
    return rc::gen::container<std::vector<T>>(static_cast<std::size_t>(n), gen);
  });
}

rc::Gen<Spec> specs() {
  using rc::gen::inRange;
  const auto actions = few<StepSpec>(1, 3, few<CommandSpec>(0, 4, command_specs()));
  const auto event =
      rc::gen::construct<EventSpec>(inRange(0, 400), inRange(0, 10), inRange(0, 6), inRange(0, 60));
  return rc::gen::construct<Spec>(inRange(0, 2), inRange(0, 16), inRange(0, 3), actions, actions,
                                  few<EventSpec>(0, 5, event));
}

TEST(RandomActions, KeepTheLawsInEveryTick) {
  setenv("RC_PARAMS", "seed=20 max_success=300 max_size=100", 0);
  const bool kept = rc::check([] {
    const Spec spec = *rc::gen::resize(100, specs()).as("spec");
    Play{spec}();
  });
  EXPECT_TRUE(kept);
}

}  // namespace
}  // namespace hexagait
