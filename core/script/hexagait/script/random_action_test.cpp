// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>
#include <hexagait/urdf/urdf.hpp>
#include <testing/counted_allocations.hpp>
#include <testing/random_actions.hpp>
#include <testing/scripted_robot.hpp>
#include <testing/source_path.hpp>

// Whatever is commanded when, and whatever feet feel: laws that hold in every tick, of random
// actions that are preempted, replaced, paused and stopped on ground that comes and goes, at any
// control period. More of them:
// RC_PARAMS="max_success=100000" script_test --gtest_filter='RandomActions.*'

namespace hexagait::random_action_test {
namespace {

using testing::ActionSpec;
using testing::ScriptedRobot;
using testing::operator<<;
using Touch = ScriptedRobot::Touch;

struct EventSpec {
  int tick = 0, kind = 0, leg = 0, length = 0;
};
struct Spec {
  int robot = 0, params = 0, ground = 0;
  int period = 2;  ///< [ms]
  ActionSpec action, other;
  std::vector<EventSpec> events;
};

std::ostream& operator<<(std::ostream& os, const EventSpec& e) {
  return os << '{' << e.tick << ',' << e.kind << ',' << e.leg << ',' << e.length << '}';
}
std::ostream& operator<<(std::ostream& os, const Spec& s) {
  return os << '{' << s.robot << ',' << s.params << ',' << s.ground << ',' << s.period << ','
            << s.action << ',' << s.other << ',' << s.events << '}';
}

RobotModel robot(const char* name) {
  return load_urdf(testing::source_path("robots/" + std::string(name)));
}
const RobotModel& robot(int index) {
  static const RobotModel robots[] = {robot("argos.urdf"), robot("quadruped.urdf"),
                                      robot("hexapod_4dof.urdf"), robot("quadruped_rpp.urdf")};
  return robots[index];
}

// Plays a specification and holds every tick to the laws.
class Play {
 public:
  explicit Play(const Spec& spec)
      : spec_(spec),
        model_(robot(spec.robot)),
        robot_(model_, params(spec)),
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
  static RunnerParams params(const Spec& spec) {
    RunnerParams params;
    const int bits = spec.params;
    params.control_dt = 1e-3 * spec.period;
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
    for (LegId i = 0; i < model_.num_legs(); ++i)
      for (int k = 0; k < model_.legs[i].num_joints(); ++k)
        robot_.measurement.q[i][k] += random_.uniform(-noise_, noise_);
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
      for (int k = 0; k < model_.legs[i].num_joints() && before.mode[i] == now.mode[i]; ++k) {
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
    const double late =
        1.03 * (record.feedback.duration + params.sequencer.planner.script.regain_limit);
    RC_ASSERT(time_ <= late + swing.unload_time + swing.search_time +
                           4.0 * params.sequencer.planner.script.pause_time + 0.1);
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
  testing::ActionWriter writer_;
  RandomSequence random_{.seed = 7, .stream = RandomStream::noise};
  double noise_ = 0.0;
  LegArray<int> silent_;     ///< ticks without contact
  LegArray<bool> airborne_;  ///< has left the ground and not touched since
  std::uint64_t action_ = 0;
  int step_ = 0;
  double time_ = 0.0, stop_ = 0.0;
};

rc::Gen<Spec> specs() {
  using rc::gen::inRange;
  const auto actions = testing::action_specs();
  const auto event =
      rc::gen::construct<EventSpec>(inRange(0, 400), inRange(0, 10), inRange(0, 6), inRange(0, 60));
  return rc::gen::construct<Spec>(inRange(0, 4), inRange(0, 16), inRange(0, 3), inRange(1, 21),
                                  actions, actions, testing::few<EventSpec>(0, 5, event));
}

TEST(RandomActions, KeepTheLawsInEveryTick) {
  setenv("RC_PARAMS", "seed=20 max_success=300 max_size=100", 0);
  const bool kept = rc::check([] {
    const Spec spec = *rc::gen::resize(100, specs()).as("spec");
    Play{spec}();
  });
  EXPECT_TRUE(kept);
}

// In each period of three ticks the foot searches, lands and begins to take load: no search lasts, no
// contact is lost, and the step must end all the same.
TEST(RandomActions, EndThoughAContactFlickersInTimeWithTheTicks) {
  const ActionSpec stands_and_steps = {
      {{.kind = 0}, {.kind = 0, .leg = 5, .frame = 2, .flags = 6, .seed = 408}}};
  const Spec spec = {.period = 16,
                     .action = stands_and_steps,
                     .other = {{}},
                     .events = {{.tick = 31, .kind = 2, .leg = 5, .length = 4}}};
  EXPECT_TRUE(rc::check([&] { Play{spec}(); }));
}

}  // namespace
}  // namespace hexagait::random_action_test
