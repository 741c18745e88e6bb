// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/executor/commands.hpp>
#include <hexagait/executor/leg_plan.hpp>

namespace hexagait {

/// What a leg is doing. Everything but `support` counts as off the ground.
enum class LegPhase : std::uint8_t {
  support,   ///< stands and carries
  unload,    ///< still stands, gives its load to the others
  lift,      ///< goes up, vertically in odom at first
  transfer,  ///< goes over to the foothold
  descend,   ///< goes down until it touches
  retreat,   ///< hit something on the way: back and up, then transfer again
  follow,    ///< moves as a LegPlan says
  search,    ///< goes on against the surface normal until it touches
  hold,      ///< stays as it is relative to the body, without carrying
};

[[nodiscard]] const char* to_string(LegPhase phase) noexcept;

/// How feet are carried through the air.
struct SwingParams {
  /// Time to hand the load over before lifting [s]. Shorter: the foot slides while it unloads.
  double unload_time = 0.04;
  /// Time in which a landed leg takes its full load [s].
  double load_time = 0.04;
  /// Time from leaving the ground to the top [s].
  double lift_time = 0.20;
  /// Share of the lift after which the foot may move sideways. Smaller is faster, but an edge
  /// beside the foot is hit more often.
  double clearance_share = 0.4;
  /// Duration of the sideways motion [s]; longer where max_speed asks for it.
  double transfer_time = 0.38;
  /// Bound on the sideways peak speed of the foot [m/s].
  double max_speed = 2.0;
  /// Descent begins when this much of the sideways motion's time is left [s].
  double overlap_time = 0.10;
  double descent_speed = 0.30;         ///< far above the expected ground [m/s]
  double touchdown_speed = 0.08;       ///< where it is expected: bounds the impact [m/s]
  double touchdown_margin = 0.006;     ///< distance from there up to which that speed is kept [m]
  double search_speed = 0.15;          ///< far below it [m/s]
  double vertical_acceleration = 6.0;  ///< in the descent [m/s²]
  /// Height above the expected ground below which the foothold is no longer moved [m].
  double commit_height = 0.03;
  double retreat_back = 0.03;  ///< after a collision [m]
  double retreat_up = 0.05;    ///< [m]
  /// Distance between the foot and its set point at which the way counts as blocked: a shin on an
  /// edge stops a leg without any contact at its foot [m].
  double blocked_error = 0.03;
  double retreat_time = 0.15;  ///< [s]
  /// A landed foot counts as support once it has kept contact for so long; until then its
  /// neighbours stay down. Shorter: a foot that bounces or scrapes along an edge is trusted, and
  /// the body drops when its neighbours lift [s].
  double confirm_time = 0.02;
  /// A support leg without contact for this long counts as off the ground [s] …
  double lost_time = 0.03;
  /// … and for this long goes down to find it again [s].
  double regain_time = 0.06;

  /// Who walks reacts: a foot that meets an edge retreats, one that finds no ground tries nearer. A
  /// scripted foot does not: it searches along the surface normal, and who sent it decides.
  bool reflexes = true;
  double search_time = 1.5;  ///< without reflexes: a search is given up after this [s]
  /// Rate at which a foot returns to the curve of its plan [1/s]. Larger: odometry's noise reaches
  /// the joints.
  double follow_rate = 10.0;
};

/// One leg's lane of the executor: which motion it is in and where its set point is. A value.
struct LegLane {
  LegPhase phase = LegPhase::support;
  double time = 0.0;               ///< in this phase [s]
  double load = 1.0;               ///< share of its load that it carries, 0 … 1
  double without_contact = 0.0;    ///< [s]
  double with_contact = 0.0;       ///< until confirmed [s]
  bool confirmed = true;           ///< the foothold has held contact for confirm_time
  Vector3 p_BF = Vector3::Zero();  ///< set point of the foot, body frame [m]
  Vector3 v_O = Vector3::Zero();   ///< its velocity over the ground, odom axes [m/s]
  Vector3 a_O = Vector3::Zero();   ///< its acceleration over the ground [m/s²]
  Footstep step;                   ///< the command being executed
  Vector3 p_OL = Vector3::Zero();  ///< where it left the ground, odom [m]
  double transfer_clock = 0.0;     ///< time since the sideways motion began [s]
  double apex_z = 0.0;             ///< height of the top of the swing, odom [m]
  bool cleared = false;            ///< contact was lost since the lift
  int retreats = 0;                ///< collisions of this step
  double reach_share = 1.0;        ///< of the way to the foothold, reduced when it can't be had
  bool touched_down = false;       ///< counts as support since this tick
  bool lifted = false;             ///< left support in this tick

  // Of legs that follow a plan.
  LegPhase after_unload = LegPhase::lift;
  Vector3 normal_O = Vector3::UnitZ();  ///< of the ground that is expected
  bool with_body = false;               ///< the plan is in the body frame, or in joints
  bool lost = false;                    ///< searches for the ground it stood on
  Vector3 p_plan = Vector3::Zero();     ///< where the plan of a foot is now, in its frame [m]
  bool exhausted = false;               ///< has searched as far as it reaches, or for too long

  /// The foot stands where it is, loaded or not.
  [[nodiscard]] bool on_ground() const {
    return phase == LegPhase::support || phase == LegPhase::unload;
  }

  /// The set point goes with the ground when the base moves; if not, it stays in the body frame.
  [[nodiscard]] bool with_ground() const {
    return phase != LegPhase::hold && !(phase == LegPhase::follow && with_body);
  }

  /// Counts as a leg on the ground for rule 1.
  [[nodiscard]] bool supports(const SwingParams& params) const {
    return phase == LegPhase::support && confirmed && without_contact <= params.lost_time;
  }
};

/// What a lane needs to know at a tick.
struct LegSensed {
  bool contact = false;
  double tracking_error = 0.0;  ///< distance of the measured foot from its set point [m]
  bool reachable = true;        ///< the last set point was within the leg's reach
};

/// Starts a step, or replaces the target of the one in progress.
void command(LegLane& lane, const Footstep& step, const Pose& X_OB) noexcept;

/// Starts a plan. A leg that carries hands its load over first.
void command(LegLane& lane, const LegPlan& plan, const Pose& X_OB) noexcept;

/// One tick of LegPhase::follow. Contact ends a plan that lands, once the foot has left the ground
/// and is past half of its time or on its way down; the end of such a plan without contact becomes
/// a search along the normal.
/// @param rate  of the plan's time: 0 stands still, 1 as planned
void follow(LegLane& lane, LegPlan& plan, const LegSensed& sensed, const Pose& X_OB, double dt,
            double rate, const SwingParams& params) noexcept;

/// Ends a plan where it is: a foot in the air that is to stand goes down, any other stays.
void interrupt(LegLane& lane, bool to_stand) noexcept;

/// Advances the lane by dt. The set point has been carried along with the ground already.
void advance(LegLane& lane, const LegSensed& sensed, const Pose& X_OB, double dt,
             const SwingParams& params) noexcept;

}  // namespace hexagait
