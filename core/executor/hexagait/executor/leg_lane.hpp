// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/executor/commands.hpp>
#include <hexagait/executor/leg_plan.hpp>
#include <hexagait/executor/tick_motion.hpp>
#include <hexagait/params/robot_params.hpp>

namespace hexagait {

/// The motion phase of a leg. For rule 1, every phase but `support` counts as off the ground.
enum class LegPhase : std::uint8_t {
  support,   ///< stands and carries load
  unload,    ///< stands and hands its load over
  lift,      ///< rises, at first vertically in odom
  transfer,  ///< moves over to the foothold
  descend,   ///< descends until it touches the ground
  retreat,   ///< collided on the way: moves back and up, then transfers again
  follow,    ///< follows a LegPlan
  search,    ///< moves against the surface normal until it touches the ground
  hold,      ///< is held in the body frame, without load
};

[[nodiscard]] const char* to_string(LegPhase phase) noexcept;

/// In a step, off the ground, and not on its way down yet.
[[nodiscard]] constexpr bool is_up(LegPhase phase) noexcept {
  return phase == LegPhase::lift || phase == LegPhase::transfer || phase == LegPhase::retreat;
}

/// One leg's lane of the executor: its phase and its set point. A value.
struct LegLane {
  LegPhase phase = LegPhase::support;
  double time = 0.0;                 ///< in this phase [s]
  double load = 1.0;                 ///< fraction of its load that it carries, 0 … 1
  double without_contact = 0.0;      ///< time since contact was lost [s]
  double with_contact = 0.0;         ///< duration of the present contact [s]
  bool touching = true;              ///< there was contact at the last tick
  bool believed = true;              ///< since the foot landed, contact has lasted for touch_time
  bool confirmed = true;             ///< contact has lasted for confirm_time
  Vector3 p_BF = Vector3::Zero();    ///< set point of the foot, body frame [m]
  Vector3 v_O = Vector3::Zero();     ///< its velocity over the ground, axes of odom [m/s]
  Vector3 a_O = Vector3::Zero();     ///< its acceleration over the ground, axes of odom [m/s²]
  FootstepCommand step;              ///< the command being executed
  double haste = 1.0;                ///< of this step; 1 from its first collision on
  Vector3 p_OL = Vector3::Zero();    ///< where the foot left the ground, odom [m]
  Vector2 back_O = Vector2::Zero();  ///< where a retreat goes, odom [m]
  double transfer_clock = 0.0;       ///< time since the sideways motion began, (swing 7) [s]
  double rises_from = 0.0;           ///< height at which the rise began, odom [m]
  double stood_at = 0.0;             ///< height of the foot itself when it was unloaded, odom [m]
  double apex_z = 0.0;               ///< height of the apex, odom [m]
  bool cleared = false;              ///< contact has been lost since the lift
  int retreats = 0;                  ///< tries of this step that failed
  int bounces = 0;                   ///< its touchdowns that were none, since the last retreat
  double reach_fraction = 1.0;       ///< of the way to the foothold, less when it is not reachable
  double beside = 0.0;               ///< to the left of that way [m]: the foothold is searched for
  bool touched_down = false;         ///< counts as support from this tick on
  bool lifted = false;               ///< left support in this tick
  bool probes = false;               ///< presses on what may be a wall, (step 12)
  double probed_at = 0.0;            ///< height of the foot when it began to, odom [m]
  bool found_no_ground = false;      ///< gave up in this tick as deep as it reaches
  bool regains = false;              ///< descends because it lost contact in support

  // For legs that follow a plan:
  LegPhase after_unload = LegPhase::lift;
  Vector3 normal_O = Vector3::UnitZ();  ///< of the ground that is expected
  bool with_body = false;               ///< the plan is in the body frame, or in joints
  bool lost = false;                    ///< searches for ground that it stood on
  Vector3 p_plan = Vector3::Zero();     ///< present point of the foot's plan, in its frame [m]
  bool exhausted = false;               ///< the search failed: out of reach, or too long

  /// The foot stands, loaded or not.
  [[nodiscard]] bool on_ground() const {
    return phase == LegPhase::support || phase == LegPhase::unload;
  }

  /// When the base moves, the set point moves with the ground; otherwise it stays in the body
  /// frame.
  [[nodiscard]] bool with_ground() const {
    return phase != LegPhase::hold && !(phase == LegPhase::follow && with_body);
  }

  /// Stands, and carries all of its share of the weight, or is to.
  [[nodiscard]] bool fully_loaded() const {
    return phase == LegPhase::support && load > 1.0 - kTimeTolerance;
  }

  /// Stands without contact, or looks for the contact that it lost while it stood.
  [[nodiscard]] bool lacks_contact() const {
    return regains || (phase == LegPhase::support && without_contact > 0.0);
  }

  /// Counts as a leg on the ground for rule 1.
  [[nodiscard]] bool supports(const SwingParams& params) const {
    return phase == LegPhase::support && confirmed && without_contact <= params.lost_time;
  }
};

/// What a lane is told about its leg in a tick.
struct LegSensed {
  bool contact = false;
  double tracking_error = 0.0;    ///< distance from where a drive with lag has its foot [m]
  bool reachable = true;          ///< the last set point was within the leg's reach
  Vector3 off = Vector3::Zero();  ///< from the set point to the measured foot, body frame [m]
  bool needed = false;            ///< it is to stay, or without it the robot would fall
  /// Speed at which it goes after its ground as it stands without contact [m/s]
  double pursuit = 0.0;
  double turn = 0.0;  ///< least time left for its transfer, (swing 7) [s]
};

/// The parameters of a swing that is `haste` times as fast, (swing 4): the same motion, but for what the
/// joints allow and what it does once it has met the ground.
/// @param haste  at least 1; 1 changes nothing
[[nodiscard]] SwingParams hastened(SwingParams params, double haste) noexcept;
/// Of these the bound on the sideways speed [m/s].
[[nodiscard]] double hastened_max_speed(const SwingParams& params, double haste) noexcept;

/// Least time left for the transfer of a leg whose foothold has changed, (swing 7) [s]; 0 in other phases.
[[nodiscard]] double turning_time(const LegLane& lane, const Pose& X_OB,
                                  const SwingParams& params) noexcept;

/// Counts how long contact lasts or is missing, from its first sample on. So a foot counts as
/// support in the tick in which it has been so for long enough, before anything is decided.
/// @param dt  control period [s]
void sense(LegLane& lane, bool contact, double dt, const SwingParams& params) noexcept;

/// Starts a step, or replaces the target of the present one.
void command(LegLane& lane, const FootstepCommand& step, const Pose& X_OB) noexcept;

/// Starts a plan. A standing leg hands its load over first.
void command(LegLane& lane, const LegPlan& plan, const Pose& X_OB) noexcept;

/// One tick of LegPhase::follow. Contact ends a plan that lands, once the foot has left the ground
/// and either moves down or half of the plan has passed. A plan that lands and ends without contact
/// continues as a search.
/// @param dt    control period [s]
/// @param rate  of the plan's time: 1 as planned, 0 paused
void follow(LegLane& lane, LegPlan& plan, const LegSensed& sensed, const Pose& X_OB, double dt,
            double rate, const SwingParams& params) noexcept;

/// Ends a plan. A foot in the air is lowered to the ground if `to_stand`, otherwise held.
void interrupt(LegLane& lane, bool to_stand) noexcept;

/// One tick of any other phase.
/// @param dt  control period [s]
/// @pre sense() has been called for this tick; the set point has been moved with the ground
void advance(LegLane& lane, const LegSensed& sensed, const Pose& X_OB, double dt,
             const SwingParams& params) noexcept;

/// A tick without a measurement: the foot goes on, and its velocity over the ground falls to 0 with
/// SwingParams::vertical_acceleration. Nothing is decided, and the time of the motion stands still.
void coast(LegLane& lane, const Pose& X_OB, double dt, const SwingParams& params) noexcept;

}  // namespace hexagait
