// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/executor.hpp>
#include <hexagait/executor/state_estimator.hpp>
#include <hexagait/plant/plant.hpp>

/// What a controller can find out by itself about its legs and their sensors, and what it does about it.
namespace hexagait::footstep_gen {

/// What has been found. A leg that is silent or noisy and a contact that flickers stay so until the next start(); a
/// stuck contact is believed again when it changes after all.
struct LegFindings {
  /// Joints do not follow, or give way under their load: the leg is dead or gone, and is lost.
  LegSet silent;
  LegSet stuck_closed;  ///< the contact never opens, not even high above the ground
  LegSet stuck_open;    ///< the contact never closes, not even where the ground stops the foot
  LegSet flickering;    ///< the contact closes high up for an instant, again and again
  LegSet noisy;         ///< joint readings of one leg are far noisier than those of the others

  /// Contacts that are not believed: the foot stands from where the ground stops it.
  [[nodiscard]] LegSet deaf() const noexcept { return stuck_closed | stuck_open | flickering; }
  [[nodiscard]] bool none() const noexcept { return (silent | deaf() | noisy).empty(); }
  friend bool operator==(const LegFindings&, const LegFindings&) = default;
};

/// Watches legs. A value; does not allocate.
///
/// **Silent.** While a leg is off the ground, with h the part of a signal that is faster than a lift,
/// q* the joint targets and q the readings,
///
///     ∫ h(q*) · h(q) dt < 1/4 ∫ |h(q*)|² dt      in four windows of (0.07 rad)² s in a row        (watch 1)
///
/// A leg that is blocked still rises, and delays of a servo are far shorter than a lift. Of a second leg
/// twelve windows are asked: with one gone feet are easily pinned.
///
/// Sooner on about level ground, while it stands and is to bear its full share of the weight, with
/// h = up · (p_F − p_F*) how far its foot is above its set point, and h̄ the mean of the others that are to bear theirs,
///
///     min(h, h − h̄) > blocked_error/2  for a quarter of the time of a lift without a break          (watch 2)
///
/// A dead leg does not bear, and the robot sinks on it. Of sound legs loads are evened out (executor 2), and h differs by
/// millimetres; where servos take no efforts all feet give way, and h − h̄ is small. It does not begin while a foot has lost
/// its contact, and is not asked of a second leg: a robot that falls may fall onto sound legs; nor of a robot that crawls.
/// Before, from 3/10 of blocked_error for a twentieth of the time of a lift on, it counts as sinking().
///
/// Soonest where its joints stand still though they should move. A foot that has lost its contact goes with the
/// ground or with its set point, and a leg that is caught can go back the way it came. With d the greatest change of
/// its readings since it lost its contact or began to retreat, e = blocked_error over the leg's reach, and while d < e/4,
///
///     |Δq*| > e/2 + 4 d  after a quarter of the time of a lift and twice the lag of the drives,
///     or it retreats, more than blocked_error/2 off its set point, for half the time of a lift     (watch 3)
///
/// Not asked of legs of two joints: their feet slide as they stand, and stick.
///
/// **Stuck closed.** The contact of a foot reads closed for 1.25 times the time of a lift without a break while the foot is
/// measured higher than half of its clearance above where it lifted.
///
/// **Stuck open.** Feet on their way down are stopped from below, beyond the lag of their drives by an
/// eighth of blocked_error, for 1.5 times that of a lift in all, and no contact is felt in between. A foot that bears its
/// share of the weight is that much above its set point, a foot in the air is not.
///
/// **Flickering.** More than six times, and more than three times as often as that of any other leg, a contact has
/// closed for no more than two control periods while the foot is that high; what is longer ago than ten times the time
/// of a lift, spent that high, counts for less.
///
/// **Noisy.** σ of the readings, by their second differences less those of the targets, times the leg's
/// reach is more than a third of blocked_error and more than three times that of any other leg. Noise
/// that all legs have is not a fault of one. The targets of a leg that retreats jump to where it is held: it is left out.
class LegWatch {
 public:
  explicit LegWatch(int legs = 0);

  /// Takes the measurement of this tick, with executor and state as the tick before left them.
  /// @param level  the ground is about level, and the robot does not sway: feet that stand bear
  /// @param dt     control period [s], after a silence too: in it the targets went on, and the robot may not have
  ///               heard them
  void watch(const RobotModel& model, const Executor& executor, const RobotState& state,
             const Measurement& measurement, SensorMask sensors, bool level, double dt) noexcept;

  [[nodiscard]] const LegFindings& findings() const { return findings_; }

  /// Legs that do not bear the weight that they should at the moment: the robot sinks on them.
  [[nodiscard]] LegSet sinking() const { return sinking_; }

  /// The measurement with what is not believed replaced: contacts by where the ground stops the foot,
  /// or a little below where it is expected,
  /// joints by their targets.
  [[nodiscard]] Measurement mended(const Measurement& measurement, const Executor& executor,
                                   const RobotState& state) const noexcept;

 private:
  struct Leg {
    LegJoints target_slow = LegJoints::Zero(), q_slow = LegJoints::Zero();
    double asked = 0.0, answered = 0.0;  ///< of (watch 1), in the present window [rad² s]
    int silent_windows = 0;
    // Of (watch 3), where it began:
    LegJoints q_there = LegJoints::Zero(), target_there = LegJoints::Zero();
    double still = 0.0;                ///< how long its joints have stood still [s]
    double caught = 0.0;               ///< the same while it retreats [s]
    double moved = 0.0;                ///< d [rad]
    double sinking = 0.0, sunk = 0.0;  ///< how long the robot has sunk on it, without a break [s]
    double closed_high = 0.0;          ///< how long the contact has been closed high up [s]
    double flickers = 0.0;             ///< how often it has been for an instant, of late
    double pressed = 0.0;  ///< how long the ground has stopped the foot, without a break [s]
    double stopped = 0.0;  ///< the same in all, and no contact since [s]
    LegJoints error_before = LegJoints::Zero(), error_before_that = LegJoints::Zero();
    int errors = 0;         ///< in a row without a retreat, up to the three of a second difference
    double variance = 0.0;  ///< of the noisiest joint [rad²]
  };

  void watch_answer(LegId leg, const Executor& executor, const LegJoints& q, double dt) noexcept;
  void watch_stillness(LegId leg, const Executor& executor, const LegJoints& q, double reach,
                       double dt) noexcept;
  void watch_load(LegId leg, const Executor& executor, double sunk, bool all_bear,
                  double dt) noexcept;
  void watch_contact(LegId leg, const Executor& executor, const RobotState& state, bool contact,
                     double dt) noexcept;
  void watch_noise(LegId leg, const Executor& executor, const LegJoints& q, double dt) noexcept;
  void compare_noise(const RobotModel& model, const Executor& executor) noexcept;
  void compare_flickers() noexcept;

  LegArray<Leg> legs_;
  LegFindings findings_;
  LegSet sinking_;
  bool started_ = false;  ///< there was a tick before
};

}  // namespace hexagait::footstep_gen
