// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/executor/tick_motion.hpp>
#include <hexagait/footstep_gen/leg_watch.hpp>

namespace hexagait::footstep_gen {
namespace {

// Times, in those of a lift, which is as fast as the robot's legs are.
constexpr double kSlowShare = 1.0;         // time constant of the slow part
constexpr double kClosedShare = 1.25;      // high above the ground
constexpr double kStoppedShare = 1.5;      // in all, and no contact since
constexpr double kNoiseMemoryShare = 2.5;  // of the noise's mean
constexpr double kSinkingShare = 0.05;  // under its load: the feet that are up had better come down
constexpr double kSunkShare = 0.25;     // the same, until it is lost
constexpr double kStillShare = 0.25;    // without contact, and twice the lag of the drives
constexpr double kCaughtShare = 0.5;    // in a retreat
constexpr double kFlickerShare = 10.0;  // in which flickers count, high above the ground

constexpr double kWindow = 0.07 * 0.07;    // asked of a leg before its answer is judged [rad² s]
constexpr double kAnswer = 0.25;           // least share of what is asked
constexpr int kWindows = 4;                // in a row
constexpr int kWindowsMore = 12;           // the same of a second leg
constexpr double kSinking = 0.3;           // of blocked_error
constexpr double kSunk = 0.5;              // of blocked_error
constexpr double kStill = 0.25;            // of blocked_error
constexpr double kGone = 0.5;              // of blocked_error, and
constexpr double kPerMoved = 4.0;          // of what the joints have moved
constexpr double kLags = 2.0;              // of the drives, that are waited for
constexpr double kCaught = 0.5;            // of blocked_error
constexpr double kHigh = 0.5;              // of the clearance
constexpr double kStopShare = 0.125;       // of blocked_error
constexpr double kBelow = 2.0;             // touchdown_margin below where the ground is expected
constexpr double kNoiseShare = 1.0 / 3.0;  // of blocked_error
constexpr double kNoisier = 3.0;           // than other legs
constexpr double kFlickers = 6.0;          // of a contact that is not believed
constexpr double kInstant = 2.5;           // control periods

// The leg with the greatest value, and the greatest of the others; values are at least 0.
struct Outlier {
  LegId leg = 0;
  double value = 0.0, next = 0.0;
};

template <class Value>
Outlier outlier(LegSet legs, const Value& value) {
  Outlier found;
  for (LegId i = 0; i < kMaxLegs; ++i) {
    if (!legs.contains(i)) continue;
    const double of_leg = value(i);
    if (of_leg > found.value)
      found = {i, of_leg, found.value};
    else
      found.next = std::max(found.next, of_leg);
  }
  return found;
}

bool goes_down(LegPhase phase) { return phase == LegPhase::descend || phase == LegPhase::search; }

// Does the ground stop a foot on its way down? Not that its drive is late, by as much as its lag may be
// misjudged.
bool stopped_from_below(LegId leg, const Executor& executor, const RobotState& state) {
  const SwingParams& swing = executor.params().swing;
  const double lag = executor.drive_lag();
  const double bound = kStopShare * swing.blocked_error + 0.25 * lag * swing.descent_speed;
  const double late = lag * std::max(0.0, -executor.legs()[leg].v_O.z());
  const Vector3 up_B = state.X_OB.R.row(2);
  return executor.tracking_error(leg) > bound && up_B.dot(executor.off(leg)) > bound + late;
}

// So far below where the ground is expected that the foot had better stand: the loads are evened out
// once it does.
bool is_below(const LegLane& lane, const Executor& executor, const RobotState& state) {
  const double below = kBelow * executor.params().swing.touchdown_margin;
  return (state.X_OB * lane.p_BF).z() < lane.step.p_OT.z() - below;
}

// min(h, h − h̄) of (watch 2) [m]; 0 of legs that are not to bear their full share, and once a leg is lost: the robot may fall onto
// sound legs.
LegArray<double> sunk(const Executor& executor, const RobotState& state) {
  const int n = executor.legs().size();
  LegArray<double> sunk(n, 0.0);
  if (!executor.held_by_set_points() || !executor.lost().empty()) return sunk;
  const Vector3 up_B = state.X_OB.R.row(2);
  LegSet bear;
  double sum = 0.0;
  for (LegId i = 0; i < n; ++i) {
    if (!executor.legs()[i].fully_loaded()) continue;
    bear.insert(i);
    sunk[i] = up_B.dot(executor.off(i));
    sum += sunk[i];
  }
  const double others = bear.size() - 1;
  for (LegId i = 0; i < n; ++i)
    if (bear.contains(i))
      sunk[i] = others > 0.0 ? std::min(sunk[i], sunk[i] - (sum - sunk[i]) / others) : 0.0;
  return sunk;
}

}  // namespace

LegWatch::LegWatch(int legs) : legs_(legs) {}

void LegWatch::watch(const RobotModel& model, const Executor& executor, const RobotState& state,
                     const Measurement& measurement, SensorMask sensors, bool level,
                     double dt) noexcept {
  const LegArray<double> below = sunk(executor, state);
  sinking_ = {};
  const bool all_bear = level && std::ranges::none_of(executor.legs(), &LegLane::regains);
  for (LegId i = 0; i < legs_.size(); ++i) {
    if (executor.lost().contains(i)) continue;
    if (sensors.joint_feedback) {
      watch_answer(i, executor, measurement.q[i], dt);
      if (!model.legs[i].has_two_joints())
        watch_stillness(i, executor, measurement.q[i], model.legs[i].max_reach, dt);
      watch_load(i, executor, below[i], all_bear, dt);
      watch_noise(i, executor, measurement.q[i], dt);
    }
    if (sensors.foot_contacts) watch_contact(i, executor, state, measurement.contact[i], dt);
  }
  if (sensors.joint_feedback) compare_noise(model, executor);
  if (sensors.foot_contacts) compare_flickers();
  started_ = true;
}

void LegWatch::watch_answer(LegId leg, const Executor& executor, const LegJoints& q,
                            double dt) noexcept {
  Leg& of = legs_[leg];
  const LegJoints& target = executor.targets().q[leg];
  if (!started_) {
    of.target_slow = target;
    of.q_slow = q;
  }
  const LegJoints asked = target - of.target_slow, answered = q - of.q_slow;
  const double slow = kSlowShare * executor.params().swing.lift_time;
  of.target_slow += dt / (slow + dt) * asked;
  of.q_slow += dt / (slow + dt) * answered;
  const LegPhase phase = executor.legs()[leg].phase;
  if (!is_up(phase) && !goes_down(phase)) return;
  of.asked += dt * asked.squaredNorm();
  of.answered += dt * asked.dot(answered);
  if (of.asked < kWindow) return;
  of.silent_windows = of.answered < kAnswer * of.asked ? of.silent_windows + 1 : 0;
  of.asked = of.answered = 0.0;
  if (of.silent_windows >= (executor.lost().empty() ? kWindows : kWindowsMore))
    findings_.silent.insert(leg);
}

// (watch 3)
void LegWatch::watch_stillness(LegId leg, const Executor& executor, const LegJoints& q,
                               double reach, double dt) noexcept {
  const SwingParams& swing = executor.params().swing;
  const LegJoints& target = executor.targets().q[leg];
  const LegLane& lane = executor.legs()[leg];
  const double error = swing.blocked_error / reach;
  const bool caught = lane.phase == LegPhase::retreat &&
                      executor.tracking_error(leg) > kCaught * swing.blocked_error;
  Leg& of = legs_[leg];
  of.moved = std::max(of.moved, (q - of.q_there).cwiseAbs().maxCoeff());
  if ((!lane.lacks_contact() && !caught) || of.moved > kStill * error) {
    of.q_there = q;
    of.target_there = target;
    of.still = of.caught = of.moved = 0.0;
    return;
  }
  of.still += dt;
  if (caught) of.caught += dt;
  const double gone = (target - of.target_there).cwiseAbs().maxCoeff();
  const double time = kStillShare * swing.lift_time + kLags * executor.drive_lag();
  if ((of.still > time && gone > kGone * error + kPerMoved * of.moved) ||
      of.caught > kCaughtShare * swing.lift_time)
    findings_.silent.insert(leg);
}

// (watch 2). Where a foot has lost its contact first, its leg may be gone, and the robot falls onto sound ones.
void LegWatch::watch_load(LegId leg, const Executor& executor, double sunk, bool all_bear,
                          double dt) noexcept {
  const SwingParams& swing = executor.params().swing;
  Leg& of = legs_[leg];
  const bool sinks = sunk > kSinking * swing.blocked_error && (all_bear || of.sinking > 0.0);
  of.sinking = sinks ? of.sinking + dt : 0.0;
  of.sunk = sinks && sunk > kSunk * swing.blocked_error ? of.sunk + dt : 0.0;
  sinking_.set(leg, of.sinking > kSinkingShare * swing.lift_time);
  if (of.sunk > kSunkShare * swing.lift_time) findings_.silent.insert(leg);
}

void LegWatch::watch_contact(LegId leg, const Executor& executor, const RobotState& state,
                             bool contact, double dt) noexcept {
  Leg& of = legs_[leg];
  const LegLane& lane = executor.legs()[leg];
  const double lift_time = executor.params().swing.lift_time;
  const double risen = (state.X_OB * state.p_BF[leg]).z() - lane.p_OL.z();
  const bool high = is_up(lane.phase) && risen > kHigh * lane.step.profile_height;
  if (high) {
    of.flickers -= decay_share(dt / (kFlickerShare * lift_time)) * of.flickers;
    if (!contact && of.closed_high > 0.0 && of.closed_high < kInstant * dt) of.flickers += 1.0;
  }
  if (high || !contact) of.closed_high = contact ? of.closed_high + dt : 0.0;
  if (of.closed_high > kClosedShare * lift_time) findings_.stuck_closed.insert(leg);
  if (!contact) findings_.stuck_closed.erase(leg);

  const bool stopped = goes_down(lane.phase) && stopped_from_below(leg, executor, state);
  of.pressed = stopped ? of.pressed + dt : 0.0;
  of.stopped = contact ? 0.0 : of.stopped + (stopped ? dt : 0.0);
  if (of.stopped > kStoppedShare * lift_time) findings_.stuck_open.insert(leg);
  if (contact) findings_.stuck_open.erase(leg);
}

void LegWatch::compare_flickers() noexcept {
  const Outlier most =
      outlier(LegSet::all(legs_.size()), [this](LegId i) { return legs_[i].flickers; });
  if (most.value > kFlickers && most.value > kNoisier * most.next)
    findings_.flickering.insert(most.leg);
}

void LegWatch::watch_noise(LegId leg, const Executor& executor, const LegJoints& q,
                           double dt) noexcept {
  Leg& of = legs_[leg];
  const LegJoints error = q - executor.targets().q[leg];
  constexpr int kEnough = 3;  // for a second difference
  of.errors =
      executor.legs()[leg].phase == LegPhase::retreat ? 0 : std::min(of.errors + 1, kEnough);
  if (of.errors == kEnough) {
    const LegJoints second = error - 2.0 * of.error_before + of.error_before_that;
    const double memory = kNoiseMemoryShare * executor.params().swing.lift_time;
    const double square = second.cwiseAbs2().maxCoeff() / 6.0;
    of.variance += dt / (memory + dt) * (square - of.variance);
  }
  of.error_before_that = of.error_before;
  of.error_before = error;
}

void LegWatch::compare_noise(const RobotModel& model, const Executor& executor) noexcept {
  const LegSet legs = without(LegSet::all(legs_.size()), executor.lost());
  const Outlier most = outlier(legs, [this](LegId i) { return legs_[i].variance; });
  const double bound =
      kNoiseShare * executor.params().swing.blocked_error / model.legs[most.leg].max_reach;
  if (most.value > bound * bound && most.value > kNoisier * kNoisier * most.next)
    findings_.noisy.insert(most.leg);
}

Measurement LegWatch::mended(const Measurement& measurement, const Executor& executor,
                             const RobotState& state) const noexcept {
  Measurement mended = measurement;
  for (LegId i = 0; i < legs_.size(); ++i) {
    if (findings_.noisy.contains(i)) mended.q[i] = executor.targets().q[i];
    if (!findings_.deaf().contains(i)) continue;
    const LegLane& lane = executor.legs()[i];
    mended.contact[i] =
        lane.on_ground() ||
        (goes_down(lane.phase) && (legs_[i].pressed >= executor.params().swing.confirm_time ||
                                   is_below(lane, executor, state)));
  }
  return mended;
}

}  // namespace hexagait::footstep_gen
