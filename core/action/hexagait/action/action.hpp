// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/action/frames.hpp>
#include <hexagait/curves/knots.hpp>
#include <hexagait/params/robot_params.hpp>
#include <hexagait/text/mark.hpp>
#include <string>
#include <variant>
#include <vector>

namespace hexagait::action {

// The commands of [FG16] Table I as scripts write them: in any frame, with targets and average
// rates. When a step starts, its commands are resolved into plans over time in odom, or in the body
// frame if they are given there. Plain values; load_action() reads them from YAML. Rates, times and
// heights that are kDerived are those of the robot: ScriptParams.

using hexagait::Mark;

struct Position {
  FrameId frame = kOdom;
  Vector3 p = Vector3::Zero();  ///< [m]
};

struct Direction {
  FrameId frame = kOdom;
  Vector3 v = Vector3::UnitZ();  ///< of any length
};

/// What all motions of a leg have in common.
struct LegMotion {
  LegId leg = 0;
  bool ignore_contact = false;              ///< no contact at the end: the leg stays in the air
  bool ignore_for_pose_adaptation = false;  ///< BaseAuto ignores this foot
  Direction surface_normal;                 ///< of the expected ground
};

/// Lifts the foot, carries it over, puts it down. (Not the FootstepCommand of a gait generator.)
struct Footstep : LegMotion {
  Position target;
  double profile_height = kDerived;  ///< [m]
  SwingProfile profile = SwingProfile::triangle;
  double average_velocity = kDerived;   ///< [m/s]
  std::optional<double> duration = {};  ///< [s]; if set, average_velocity is not used
};

/// Moves the foot to a position.
struct EndEffectorTarget : LegMotion {
  Position target;
  Vector3 velocity = Vector3::Zero();      ///< at the target, in its frame [m/s]
  Vector3 acceleration = Vector3::Zero();  ///< [m/s²]
  Vector3 force = Vector3::Zero();         ///< of the foot on the world, fed forward [N]
  double average_velocity = kDerived;      ///< [m/s]
};

/// Moves the foot along a trajectory. Velocities that are not given are chosen for a smooth curve.
struct EndEffectorTrajectory : LegMotion {
  FrameId frame = kOdom;
  std::vector<FootKnot> knots;
};

/// Moves the joints to a target; NaN for what is not given. Without positions the velocities are
/// integrated; with efforts alone the leg is driven by effort.
struct JointTarget : LegMotion {
  JointKnot target;                    ///< its time is not used
  double average_velocity = kDerived;  ///< of the joint with the largest motion [rad/s]
};

/// Moves the joints along a trajectory.
struct JointTrajectory : LegMotion {
  std::vector<JointKnot> knots;
};

/// Makes a leg a support leg, or lifts it out of support, where it is.
struct LegMode : LegMotion {
  bool support_leg = false;
  double duration = kDerived;  ///< [s]
};

/// Moves the base to where it is best held over the feet ([FG16] II-D).
struct BaseAuto {
  /// Above the mean height of the feet [m]; without one, that of the previous BaseAuto.
  std::optional<double> height;
  bool ignore_timing_of_leg_motion = false;
  double average_linear_velocity = kDerived;   ///< [m/s]
  double average_angular_velocity = kDerived;  ///< [rad/s]
  double support_margin = kDerived;            ///< [m]
};

/// Moves the base to a pose.
struct BaseTarget {
  FrameId frame = kOdom;
  Pose X_AB;
  bool ignore_timing_of_leg_motion = false;
  double average_linear_velocity = kDerived;   ///< [m/s]
  double average_angular_velocity = kDerived;  ///< [rad/s]
};

/// Moves the base along a trajectory.
struct BaseTrajectory {
  FrameId frame = kOdom;
  std::vector<BaseKnot> knots;
};

/// A command for the program itself: passed to the handler registered for `type`.
struct CustomCommand {
  int handler = 0;  ///< index of the type among those registered
  std::string type;
  double duration = 0.0;  ///< [s]
  std::string command;    ///< one line of YAML, references and placeholders resolved
};

/// Waits.
struct Wait {
  double duration = 0.0;  ///< [s]
};

struct LegCommand {
  std::variant<Footstep, EndEffectorTarget, EndEffectorTrajectory, JointTarget, JointTrajectory,
               LegMode>
      motion;
  Mark mark;
};

struct BaseCommand {
  std::variant<BaseAuto, BaseTarget, BaseTrajectory> motion;
  Mark mark;
};

/// Motions that start together. The next step starts when all of them have ended.
struct Step {
  std::vector<LegCommand> legs;  ///< at most one per leg
  std::optional<BaseCommand> base;
  std::vector<CustomCommand> custom;
  Wait wait;  ///< least duration of the step
  Mark mark;
};

/// Commands given in frame `source` are fixed to frame `target` when the action starts:
/// X_TA = X_TS · X_S · X_SA, with X_TS at that time.
struct Adaptation {
  FrameId source = kFootprint;
  FrameId target = kOdom;  ///< not `source`
  Pose X_S;                ///< transform in the source frame
  bool yaw_only = false;   ///< only yaw and position of X_TS are used
};

/// Steps that are executed one after the other.
struct Action {
  std::string id;      ///< name
  std::string source;  ///< file from which it was read
  std::vector<Adaptation> adapt_coordinates;
  std::vector<Step> steps;
  std::string robot = {};  ///< name of the robot that its numbers are for; empty: of any
};

/// The LegMotion of any command. Unlike std::visit it cannot throw, so ticks can use it.
[[nodiscard]] inline const LegMotion& leg_motion(const LegCommand& command) noexcept {
  const auto base = []<class... Motion>(const std::variant<Motion...>& motion) noexcept {
    const LegMotion* found = nullptr;
    ((found = found ? found : std::get_if<Motion>(&motion)), ...);
    return found;
  };
  return *base(command.motion);
}

}  // namespace hexagait::action
