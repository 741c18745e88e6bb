// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/executor/commands.hpp>
#include <hexagait/executor/leg_plan.hpp>
#include <limits>

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

/// Parameters of the swing and of contact.
struct SwingParams {
  /// Time in which a leg hands its load over before lifting [s]. Shorter: the foot slides.
  double unload_time = 0.04;
  /// Time in which a landed leg takes its full load [s]. It counts as support when it has it, so
  /// longer than confirm_time costs speed. Shorter: the load of the feet jumps.
  double load_time = 0.02;
  /// Rate at which the feet that stand even out their loads [1/s]. 0: a foot that stands too high
  /// for the others carries little, and loses the ground. Higher: the body sways.
  double even_load_rate = 20.0;
  /// Time from leaving the ground to the apex [s]; longer where the joints' speed requires it.
  double lift_time = 0.20;
  /// Fraction of the profile height from which the foot moves sideways. Smaller: faster, but the
  /// foot hits edges beside it more often.
  double clearance_share = 0.4;
  /// Duration of the sideways motion [s]; longer where max_speed requires it.
  double transfer_time = 0.38;
  /// Bound on the peak sideways speed of the foot [m/s].
  double max_speed = 2.0;
  /// The descent begins when this much of the sideways motion's time is left [s].
  double overlap_time = 0.10;
  double descent_speed = 0.30;         ///< well above the expected ground [m/s]
  double touchdown_speed = 0.08;       ///< at the expected ground: bounds the impact [m/s]
  double touchdown_margin = 0.006;     ///< range of that speed around the expected ground [m]
  double search_speed = 0.15;          ///< below the expected ground [m/s]
  double vertical_acceleration = 6.0;  ///< of the descent [m/s²]
  /// Height above the expected ground below which the foot moves only vertically [m].
  double commit_height = 0.03;
  double retreat_back = 0.03;  ///< distance moved back after a collision [m]
  double retreat_up = 0.05;    ///< rise after a collision [m]
  /// Distance between the foot and where its drive, with its lag, would have it, that counts as a
  /// collision: a shin against an edge stops the leg without a contact at its foot [m].
  double blocked_error = 0.008;
  double retreat_time = 0.15;  ///< [s]
  /// Collisions in one step after which the foot goes back to where it stood, and stays down. Each
  /// try costs half a second, in which its neighbours wait.
  int max_retreats = 5;
  /// Duration of contact before it is believed: before a foot on its way counts as blocked, and
  /// before one that has landed takes load. A contact that ends sooner was none, and the step goes
  /// on. Shorter: false contacts end steps. Longer: what blocks a foot is pushed for longer [s].
  double touch_time = 0.01;
  /// Duration of contact after which a landed foot counts as support; until then its neighbours
  /// stay down. Shorter: feet that bounce or scrape along an edge are trusted, and the body drops
  /// when the neighbours lift [s].
  double confirm_time = 0.02;
  /// Time without contact after which a support leg counts as off the ground [s].
  double lost_time = 0.03;
  /// Time without contact after which a support leg moves down to regain it [s].
  double regain_time = 0.06;
  /// A foothold gives way if the foot slides by more than this within about slide_time [m]: the legs
  /// beside it stay down, and the base waits. Smaller: feet that only settle, and noise, count. Larger:
  /// feet that roll off an edge are found too late.
  double slide_distance = 0.002;
  double slide_time = 0.1;  ///< [s]
  /// true (walking): a foot that collides retreats, and one that finds no ground tries a closer
  /// place. false (scripts): the foot searches along the surface normal, and the sequencer decides.
  bool reflexes = true;
  double search_time = 1.5;  ///< without reflexes: longest search [s]
  /// Rate at which a foot returns to the curve of its plan [1/s]. Larger: more of odometry's noise
  /// reaches the joints.
  double follow_rate = 10.0;
};

/// One leg's lane of the executor: its phase and its set point. A value.
struct LegLane {
  LegPhase phase = LegPhase::support;
  double time = 0.0;               ///< in this phase [s]
  double load = 1.0;               ///< fraction of its load that it carries, 0 … 1
  double without_contact = 0.0;    ///< time since contact was lost [s]
  double with_contact = 0.0;       ///< duration of the present contact [s]
  bool touching = true;            ///< there was contact at the last tick
  bool believed = true;            ///< since the foot landed, contact has lasted for touch_time
  bool confirmed = true;           ///< contact has lasted for confirm_time
  Vector3 p_BF = Vector3::Zero();  ///< set point of the foot, body frame [m]
  /// Bound of its upward speed, by the speed of the joints [m/s].
  double max_rise = std::numeric_limits<double>::infinity();
  Vector3 v_O = Vector3::Zero();     ///< its velocity over the ground, axes of odom [m/s]
  Vector3 a_O = Vector3::Zero();     ///< its acceleration over the ground, axes of odom [m/s²]
  FootstepCommand step;              ///< the command being executed
  Vector3 p_OL = Vector3::Zero();    ///< where the foot left the ground, odom [m]
  Vector2 back_O = Vector2::Zero();  ///< where a retreat goes, odom [m]
  double transfer_clock = 0.0;       ///< time since the sideways motion began [s]
  double apex_z = 0.0;               ///< height of the apex, odom [m]
  bool cleared = false;              ///< contact has been lost since the lift
  int retreats = 0;                  ///< collisions of this step
  double reach_fraction =
      1.0;                    ///< of the distance to the foothold, reduced when it is not reachable
  bool touched_down = false;  ///< counts as support from this tick on
  bool lifted = false;        ///< left support in this tick

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
};

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
