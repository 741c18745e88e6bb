// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>

namespace hexagait {

/// A parameter with this value follows from the robot's model: params_for(). All lengths, times,
/// forces and gains below have it until they are set, so that none is made for one robot. It is a
/// NaN with bits of its own: a NaN that a computation made is a mistake, and stays one.
inline constexpr double kDerived = std::bit_cast<double>(std::uint64_t{0x7FF8'0000'6465'7276});

[[nodiscard]] constexpr bool is_derived(double value) noexcept {
  return std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(kDerived);
}

/// Parameters of the gait generator's steps.
struct StepParams {
  /// Path of the body between two landings of one foot, at the farthest workspace centre [m]. Half
  /// of it is the AEP's distance from the centre. Longer: faster, until the workspaces limit it.
  double stroke = kDerived;
  /// Clearance of the swing over rough ground [m]. Higher: climbs higher steps, walks more slowly.
  double height = kDerived;
  /// Share of `height` on level ground, by (step 2). 1: the same everywhere. Smaller: faster, but the
  /// first edge is found by running into it.
  double level_height = kDerived;
  /// How many times as fast as SwingParams says feet swing on level ground, by (step 3); at least 1.
  /// Higher: faster, until the joints limit it; feet run into edges harder.
  double haste = kDerived;
  /// How many times SwingParams::descent_speed feet have where prints differ by more than the height above and
  /// drives are prompt, by (step 9); at least 1. Higher: faster over rough ground, and harder impacts there.
  double descent = kDerived;
  /// How many times SwingParams::touchdown_speed feet have at the expected ground where its height is a
  /// guess, by (step 6); at least 1. Higher: faster over rough ground, and harder impacts there.
  double touchdown = kDerived;
  /// Share of SwingParams::touchdown_margin over which feet are slow: 1, but on level ground, by (step 10).
  double slow_way = 1.0;
  /// Share of what lies beyond its workspace, of the advance to come, that a foot on its way down still counts on:
  /// 1, but on level ground, by (step 10).
  double overreach = 1.0;
  /// Clearance added per metre by which another foot's last footprint is higher [m/m]: after one
  /// step in the ground, others are likely. 0: the foot collides with edges higher than the
  /// clearance.
  double roughness_gain = 1.0;
  double max_height = kDerived;  ///< bound of the clearance [m]
  /// Fraction of its workspace radius from which a leg's lag is urgent: the latch then drops the
  /// leg's adjusted relations.
  double urgent_share = 0.8;
  /// Least distance of the centre of mass from the edges of the support polygon: the base waits
  /// before [m]. 0: crabbing at 45°, where the support triangle is narrow, tips the robot.
  double stability_margin = kDerived;
  /// The same of the feet that stay when a robot of four or five legs lifts one: the leg waits, and
  /// the base moves there [m]. Smaller: less sway and faster; the body tips when it is pushed.
  double lift_margin = kDerived;
};

/// Parameters of the swing and of contact.
struct SwingParams {
  /// Time in which a leg hands its load over before lifting [s]. Shorter: the foot slides.
  double unload_time = kDerived;
  /// Time in which a landed leg takes its full load [s]. It counts as support when it has it, so
  /// longer than confirm_time costs speed. Shorter: the load of the feet jumps.
  double load_time = kDerived;
  /// Rate at which the feet that stand even out their loads [1/s]. 0: a foot that stands too high
  /// for the others carries little, and loses the ground. Higher: the body sways.
  double even_load_rate = kDerived;
  /// Time from leaving the ground to the apex [s]; longer where max_rise requires it.
  double lift_time = kDerived;
  /// Bound on the peak speed of the rise: the joints can follow [m/s].
  double max_rise = kDerived;
  /// Fraction of the profile height from which the foot moves sideways. Smaller: faster, but the
  /// foot hits edges beside it more often.
  double clearance_share = 0.4;
  /// Duration of the sideways motion [s]; longer where max_speed requires it.
  double transfer_time = kDerived;
  /// Bound on the peak sideways speed of the foot [m/s].
  double max_speed = kDerived;
  /// The same bound of hasty steps: max_speed grows with their haste up to this [m/s].
  double hasty_speed = kDerived;
  /// The descent begins when this much of the sideways motion's time is left [s].
  double overlap_time = kDerived;
  double descent_speed = kDerived;          ///< well above the expected ground [m/s]
  double touchdown_speed = kDerived;        ///< at the expected ground: bounds the impact [m/s]
  double touchdown_margin = kDerived;       ///< range of that speed around the expected ground [m]
  double search_speed = kDerived;           ///< below the expected ground [m/s]
  double vertical_acceleration = kDerived;  ///< of the descent [m/s²]
  /// Height above the expected ground below which the foot moves only vertically [m].
  double commit_height = kDerived;
  double retreat_back = kDerived;  ///< distance moved back after a collision [m]
  double retreat_up = kDerived;    ///< rise after a collision [m]
  /// Distance between the foot and where its drive, with its lag, would have it, that counts as a
  /// collision: a shin against an edge stops the leg without a contact at its foot [m].
  double blocked_error = kDerived;
  double retreat_time = kDerived;  ///< [s]
  /// Collisions in one step after which the foot goes back to where it stood; with more it searches
  /// (swing 5). Each try costs half a second, in which its neighbours wait.
  int max_retreats = 5;
  /// Touchdowns of one foot in a row that end without hold, after which it tries a closer place.
  int max_bounces = 3;
  /// Duration of contact before it is believed: before a foot on its way counts as blocked, and
  /// before one that has landed takes load. A contact that ends sooner was none, and the step goes
  /// on. Shorter: false contacts end steps. Longer: what blocks a foot is pushed for longer [s].
  double touch_time = kDerived;
  /// Duration of contact after which a landed foot counts as support; until then its neighbours
  /// stay down. Shorter: feet that bounce or scrape along an edge are trusted, and the body drops
  /// when the neighbours lift [s].
  double confirm_time = kDerived;
  /// Time without contact after which a support leg counts as off the ground [s].
  double lost_time = kDerived;
  /// Time without contact after which a support leg moves down to regain it [s].
  double regain_time = kDerived;
  /// A foothold gives way if the foot slides by more than this within about slide_time [m]: the legs
  /// beside it stay down, and the base waits. Smaller: feet that only settle, and noise, count. Larger:
  /// feet that roll off an edge are found too late.
  double slide_distance = kDerived;
  double slide_time = kDerived;  ///< [s]
  /// The robot waits for so long, in all, for a foothold that gives way [s].
  double slide_patience = kDerived;
  /// true (walking): a foot that collides retreats, and one that finds no ground tries a closer
  /// place. false (scripts): the foot searches along the surface normal, and the sequencer decides.
  bool reflexes = true;
  double search_time = kDerived;  ///< without reflexes: longest search [s]
  /// Rate at which a foot returns to the curve of its plan [1/s]. Larger: more of odometry's noise
  /// reaches the joints.
  double follow_rate = kDerived;
  /// Time in which a planned effort may rise from 0 to the joint's limit [s].
  double effort_time = kDerived;
  /// Slower set points say nothing about the lag of the drives: there friction and load deflect
  /// them more [m/s].
  double lag_speed = kDerived;
};

/// Limits and gains of the base's motion.
struct BaseParams {
  /// Bound on the acceleration along the path, at the outermost foot [m/s²]. Larger: the
  /// zero-moment point leaves the support triangle and feet lose contact.
  double acceleration = kDerived;
  /// Way after which motion away from the path has fallen to 1/√e, if the zero-moment point may go
  /// so far; motion that `acceleration` ends within this way is left to it [m].
  double braking_distance = kDerived;
  double max_speed = kDerived;         ///< along the path [m/s]
  double advance_rate = kDerived;      ///< speed over remaining path, near the goal [1/s]
  double correction_rate = kDerived;   ///< speed over deviation from the path [1/s]
  double correction_speed = kDerived;  ///< bound of the correction [m/s]
  double correction_turn = kDerived;   ///< the same [rad/s]
  double posture_rate = kDerived;      ///< speed over error of height, roll and pitch [1/s]
  double height_speed = kDerived;      ///< bound [m/s]
  double tilt_speed = kDerived;        ///< bound [rad/s]
  double outer_radius = kDerived;      ///< lever arm from angular to linear acceleration [m]
  /// Duration of one displacement of the body, at whose end all joints of the standing legs arrive
  /// together: [PC04]'s discrete posture control, 0.05 s at a servo rate of 20 Hz [s]. 0: smooth, a
  /// target in every control period. Longer: feet slip more, by (displacement 2).
  double displacement_period = kDerived;
};

/// Natural frequencies of the base on the springs of the virtual model.
struct SpringParams {
  double frequency = kDerived;       ///< ω of its shift [rad/s]
  double turn_frequency = kDerived;  ///< ω' of its rotation [rad/s]
};

/// Tolerances of odometry and gait.
struct ToleranceParams {
  double tie = kDerived;  ///< GaitParams::tie_tolerance [m of path]
  /// The change of distances at which the weight of a foot is halved, ε₀ of (odometry 3) [m].
  double slide = kDerived;
  double in_a_row = kDerived;  ///< feet that are within this of a line are in a row [m]
  /// The same of legs of two joints, whose feet slide: (odometry 8) [m].
  double sliding_in_a_row = kDerived;
  /// An angle of the base counts as much as a shift by it times this [m]: (tracker 1).
  double turn_arm = kDerived;
  /// Time in which the accelerometer, where there is one, overrules the gyroscope, τ of (tilt 1): longer
  /// than a step. Shorter: the body's own accelerations count as tilt. Longer: a drifting gyroscope
  /// does [s].
  double tilt_time = kDerived;
  /// τ of (odometry 5): in so long odometry takes over what an inclinometer reads [s]. Shorter: noise and
  /// sway of the inclinometer reach the feet. Longer: an error of tilt lasts.
  double level_time = kDerived;
  /// Stiffness of the joints' servos over the robot's weight, K/(m g) of (odometry 6): without an inertial
  /// sensor the tilt of odometry is corrected by how the joints give way [m]. 0: it is not. Larger than it
  /// is: corrected too fast.
  double servo_stiffness = kDerived;
  /// τ of (odometry 7): the same for that correction [s]. Shorter: pushes and impacts count as tilt. Longer:
  /// an error of tilt lasts.
  double gravity_time = kDerived;
};

/// Durations, speeds and tolerances of scripted actions.
struct ScriptParams {
  double profile_height = kDerived;    ///< of a footstep, unless the action says so [m]
  double footstep_speed = kDerived;    ///< the same [m/s]
  double foot_speed = kDerived;        ///< of an end effector target, the same [m/s]
  double joint_speed = kDerived;       ///< of a joint target, the same [rad/s]
  double leg_mode_time = kDerived;     ///< of a leg mode, the same [s]
  double auto_speed = kDerived;        ///< of a BaseAuto, the same [m/s]
  double auto_turn = kDerived;         ///< the same [rad/s]
  double base_speed = kDerived;        ///< of a base target, the same [m/s]
  double base_turn = kDerived;         ///< the same [rad/s]
  double support_margin = kDerived;    ///< of a BaseAuto, the same [m]
  double lift_off_speed = kDerived;    ///< of a footstep, along the normal [m/s]
  double touchdown_speed = kDerived;   ///< of a footstep, against the normal [m/s]
  double footstep_time = kDerived;     ///< shortest footstep [s]
  double swing_tolerance = kDerived;   ///< closer corners of a footstep's profile count as one [m]
  double swing_braking = kDerived;     ///< of a foot in mid-air that gets a new footstep [m/s²]
  double target_time = kDerived;       ///< shortest motion to a foot's or joints' target [s]
  double base_auto_time = kDerived;    ///< shortest BaseAuto [s]
  double base_target_time = kDerived;  ///< shortest motion to a base target [s]
  double pause_time = kDerived;        ///< in which motions slow to a stop, and speed up [s]
  double reach_time = kDerived;        ///< out of reach for longer, the action fails [s]
  double regain_limit =
      kDerived;  ///< longest time of a step spent waiting for feet that should stand [s]
  double near_plan = kDerived;      ///< a base farther than this off its plan starts anew [m]
  double height_lost = kDerived;    ///< a height missed by more is not kept [m]
  double narrow_margin = kDerived;  ///< a stability margin below this is warned of [m]
};

/// What a simulated robot's drives, feet and ground are like; a real robot has its own.
struct PlantParams {
  /// Longest physics step [s]. Larger: faster, but feet drift in proportion (docs/theory.md 6).
  double longest_step = kDerived;
  /// Stiffness Kp [N m/rad] and damping Kd [N m s/rad] of every joint's servo. Too low: the body
  /// sags under its weight. Too high: feet on uneven ground build up internal forces and jump.
  double servo_kp = kDerived;
  double servo_kd = kDerived;
  /// Gain in velocity mode, τ = Kv (q̇* − q̇₊) + τ* [N m s/rad]. Too low: legs sink under their
  /// weight.
  double servo_kv = kDerived;
  /// Viscous friction D of the drive in effort mode, τ = τ* − D q̇₊ [N m s/rad].
  double servo_friction = kDerived;
  /// Normal force on a foot from which its contact sensor closes [N]. Too low: a foot that brushes
  /// an edge counts as standing. Too high: a lightly loaded foot does not.
  double contact_threshold = kDerived;
  /// Speed at which a force penetrates the ground, per newton [m/(N s)]; see WorldParams.
  double contact_cfm = kDerived;
  double contact_correcting_speed = kDerived;  ///< [m/s]
  double hinge_cfm = kDerived;                 ///< [m/(N s)], [rad/(N m s)]
  double start_clearance = kDerived;  ///< of the lowest foot above the ground at the start [m]
};

/// Thresholds by which a walk or an action is judged.
struct RefereeParams {
  /// A foot that is off the ground for less than this goes on standing: too short to tip [s].
  double bounce = kDerived;
  double settling = kDerived;    ///< a support younger than this may still lose contact [s]
  double brief_loss = kDerived;  ///< a loss of contact up to so long may be a bounce [s], ...
  double near_loss = kDerived;   ///< ... if the foot goes no farther [m]
  double fall_speed = kDerived;  ///< a base that touches the ground faster than this fell [m/s]
  /// A robot that is to move and does not make so much progress in so long is stuck [m], [s].
  double progress = kDerived;
  double patience = kDerived;
};

/// All lengths, times, forces and gains of a robot. Everything of the library that needs one reads it
/// here; params_for() derives them from the model.
struct RobotParams {
  StepParams step;
  SwingParams swing;
  BaseParams base;
  SpringParams spring;
  ToleranceParams tolerance;
  ScriptParams script;
  PlantParams plant;
  RefereeParams referee;
};

}  // namespace hexagait
