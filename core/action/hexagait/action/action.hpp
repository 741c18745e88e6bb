// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/action/frames.hpp>
#include <hexagait/curves/knots.hpp>
#include <hexagait/text/mark.hpp>
#include <string>
#include <variant>
#include <vector>

namespace hexagait::action {

// The commands of [FG16] Table I as they are written: in any frame, by targets and average rates.
// When its step starts, a command is resolved into a motion: in odom (or in the base, for what is
// given in the base), over time. Plain values; load_action() reads them from YAML.

using hexagait::Mark;

struct Position {
  FrameId frame = kOdom;
  Vector3 p = Vector3::Zero();  ///< [m]
};

struct Direction {
  FrameId frame = kOdom;
  Vector3 v = Vector3::UnitZ();  ///< need not be of length one
};

/// What all motions of a leg have.
struct LegMotion {
  LegId leg = 0;
  bool ignore_contact = false;  ///< no contact is expected at the end: the leg stays in the air
  bool ignore_for_pose_adaptation = false;  ///< BaseAuto takes no notice of this foot
  Direction surface_normal;                 ///< of the ground that is expected
};

/// Lift the foot, carry it over, put it down.
struct Footstep : LegMotion {
  Position target;
  double profile_height = 0.08;  ///< [m]
  SwingProfile profile = SwingProfile::triangle;
  double average_velocity = 0.65;       ///< [m/s]
  std::optional<double> duration = {};  ///< [s]; if there is one, average_velocity is not used
};

/// The foot to a position.
struct EndEffectorTarget : LegMotion {
  Position target;
  Vector3 velocity = Vector3::Zero();      ///< at the target, in its frame [m/s]
  Vector3 acceleration = Vector3::Zero();  ///< [m/s²]
  Vector3 force = Vector3::Zero();         ///< of the foot on the world, fed forward [N]
  double average_velocity = 0.3;           ///< [m/s]
};

/// The foot along a trajectory. Velocities that are not given are chosen for a smooth curve.
struct EndEffectorTrajectory : LegMotion {
  FrameId frame = kOdom;
  std::vector<FootKnot> knots;
};

/// What a joint command says of the joints: any of these, NaN where it says nothing.
/// Without positions the velocities are integrated; with efforts alone the leg is driven by them.
struct JointTarget : LegMotion {
  JointKnot target;               ///< time is not used
  double average_velocity = 1.0;  ///< [rad/s], of the joint that has the longest way
};

struct JointTrajectory : LegMotion {
  std::vector<JointKnot> knots;
};

/// Makes a leg a support leg, or not, where it is.
struct LegMode : LegMotion {
  bool support_leg = false;
  double duration = 0.5;  ///< [s]
};

/// The base where it is best held over the feet ([FG16] II-D).
struct BaseAuto {
  std::optional<double>
      height;  ///< above the mean of the feet [m]; none: that of the last BaseAuto
  bool ignore_timing_of_leg_motion = false;
  double average_linear_velocity = 0.2;    ///< [m/s]
  double average_angular_velocity = 0.28;  ///< [rad/s]
  double support_margin = 0.04;            ///< [m]
};

/// The base to a pose.
struct BaseTarget {
  FrameId frame = kOdom;
  Pose X_AB;
  bool ignore_timing_of_leg_motion = false;
  double average_linear_velocity = 0.05;  ///< [m/s]
  double average_angular_velocity = 0.1;  ///< [rad/s]
};

/// The base along a trajectory.
struct BaseTrajectory {
  FrameId frame = kOdom;
  std::vector<BaseKnot> knots;
};

/// Something that the program does itself: handed to the handler registered for `type`.
struct CustomCommand {
  int handler = 0;  ///< index of the type among those registered
  std::string type;
  double duration = 0.0;  ///< [s]
  std::string command;    ///< YAML text of one line, references and placeholders resolved
};

/// Do nothing for a while.
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
  Wait wait;  ///< the step lasts at least so long
  Mark mark;
};

/// Commands given in `source` are meant in `target`: when the action starts,
/// X_TA = X_TS · X_S · X_SA, with X_TS of that moment.
struct Adaptation {
  FrameId source = kFootprint;
  FrameId target = kOdom;  ///< not the source
  Pose X_S;                ///< transform in the source frame
  bool yaw_only = false;   ///< of X_TS only the yaw and the position
};

/// Steps that are carried out one after the other.
struct Action {
  std::string id;      ///< a name for people
  std::string source;  ///< file it was read from
  std::vector<Adaptation> adapt_coordinates;
  std::vector<Step> steps;
};

/// What every command of a leg has. Unlike std::visit it never throws: ticks use it.
[[nodiscard]] inline const LegMotion& leg_motion(const LegCommand& command) noexcept {
  const LegMotion* found = nullptr;
  const auto look = [&found]<class... Motion>(const std::variant<Motion...>& motion) noexcept {
    ((found = found ? found : std::get_if<Motion>(&motion)), ...);
  };
  look(command.motion);
  return *found;
}

}  // namespace hexagait::action
