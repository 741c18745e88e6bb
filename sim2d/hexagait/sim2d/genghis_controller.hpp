// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/gait_state/decide.hpp>
#include <hexagait/gait_state/gait_choice.hpp>
#include <hexagait/sim2d/genghis_model.hpp>
#include <hexagait/sim2d/genghis_world.hpp>

/// The walker of Genghis: [PC04] 3.3 for who steps, [PC04] 4 along a straight line for the body,
/// and reflexes for what the ground does. Everything is in the body frame, x forward and z up, and
/// all set points move with the ground: when the body advances, feet that stand go back.
namespace hexagait::sim2d {

struct GenghisParams {
  double control_dt = 0.005;  ///< control period [s]
  gait_state::GaitChoice gait;
  bool backward = false;
  double tie_tolerance = 1e-3;  ///< of the gait state [m]

  /// AEP, forward of the workspace centre [m]. Half of what a foot sweeps in the body frame.
  double half_stroke = 0.025;
  /// Height of the swing above the last footprint [m]. Higher meets fewer edges and walks slower.
  double clearance = 0.03;
  /// Added per metre by which another footprint is higher [m/m].
  double roughness_gain = 0.5;

  double raise_speed = 0.25, advance_speed = 0.40;  ///< [m/s]
  double swing_acceleration = 4.0;                  ///< [m/s²]; a jerk reads as a load

  /// [m/s]. What limits the robot's speed: faster, and noisy motor currents don't tell the ground
  /// from the leg's own motion ([PC04] 5.1). From 3 cm at 3.6 cm/s: 5/6 of a step, as in the
  /// paper's simulation.
  double descent_speed = 0.036;

  double body_speed = 0.12;        ///< [m/s], at most
  double body_acceleration = 0.8;  ///< [m/s²]
  double posture_rate = 2.0;       ///< how fast height and pitch follow the footprints [1/s]
  double vertical_speed = 0.04;    ///< [m/s], at most
  double pitch_speed = 0.3;        ///< [rad/s], at most
  double max_pitch = 0.5;          ///< by the inclinometer; beyond it, only back [rad]
  double usable_share = 0.98;      ///< of the reach, before the body waits for a leg
  double urgent_share = 0.8;       ///< of the reach, from which a leg is urgent (gait 4)

  double touchdown_load = 0.8;  ///< a descending foot stands from this load on [N]
  double lost_load = 0.05;      ///< a standing foot with less has lost its hold [N] …
  double lost_time = 0.06;      ///< … if it stays so for this long [s]: it descends again

  double blocked_error = 0.006;  ///< an advance that lags by more has met something [m]
  double retreat = 0.012;        ///< then: back by this [m],
  double raise_more = 0.03;      ///< up by this above where it met it [m], and again
  double presumed_drop = 0.03;   ///< no ground within reach: it is taken to be so much lower [m]
  double patience = 1.0;         ///< waits so long for the body to come lower [s], then
  double search_step = 0.02;     ///< tries so much nearer [m]
};

enum class LegPhase : std::uint8_t { support, raise, advance, retreat, descend };

/// One leg, between ticks and as a part of the record.
struct GenghisLeg {
  LegPhase phase = LegPhase::support;
  Vector2 p = Vector2::Zero();      ///< set point of the foot [m]
  Vector2 v = Vector2::Zero();      ///< its velocity [m/s]
  Vector2 print = Vector2::Zero();  ///< where it last stood, or where the ground is presumed [m]
  double height = 0.0;              ///< of the swing above `print` [m]
  double shortened = 0.0;           ///< how much nearer than the AEP it searches [m]
  double back_to = 0.0;             ///< x where the retreat ends [m]
  double clock = 0.0;               ///< without load, or without ground [s]

  // What happened in this tick.
  bool touched_down = false, lost = false, blocked = false, searched = false;
};

/// Everything that one tick computed, by stage.
struct GenghisRecord {
  // sense
  GenghisMeasurement measurement;
  LegArray<Vector2> feet;  ///< measured [m]
  // decide
  gait_state::GaitInput gait_input;
  gait_state::StepDecision decision;
  // adapt
  double advance_goal = 0.0;         ///< along the command, to the posture optimum [m]
  double to_come = 0.0;              ///< the same when all airborne feet are at their AEP [m]
  Vector2 v_body = Vector2::Zero();  ///< of the body [m/s]
  double pitch_rate = 0.0;           ///< [rad/s]
  // step
  LegArray<GenghisLeg> legs;
  // command
  GenghisTargets targets;
};

/// A value: a copy continues identically. tick() neither allocates nor throws.
class GenghisController {
 public:
  explicit GenghisController(const GenghisModel& model, const GenghisParams& params = {});

  /// Stands where the robot stands: all feet are taken to be on the ground.
  void start(const GenghisMeasurement& measurement);

  /// One control period.
  const GenghisRecord& tick(const GenghisMeasurement& measurement) noexcept;

  [[nodiscard]] const GenghisRecord& record() const { return record_; }
  [[nodiscard]] const GenghisParams& params() const { return params_; }

 private:
  void sense(const GenghisMeasurement& measurement) noexcept;
  void decide() noexcept;
  void adapt() noexcept;
  void step() noexcept;
  void command() noexcept;

  [[nodiscard]] LegSet support() const noexcept;
  [[nodiscard]] double ahead(LegId leg) const noexcept;
  [[nodiscard]] bool moves_with_ground(LegId leg) const noexcept;
  [[nodiscard]] double reach_behind(LegId leg) const noexcept;
  [[nodiscard]] Vector2 ground_velocity(const Vector2& p) const noexcept;
  [[nodiscard]] bool within_reach() const noexcept;
  void adapt_height_and_pitch() noexcept;
  void lift(LegId leg) noexcept;
  [[nodiscard]] Vector2 swing_velocity(LegId leg) noexcept;
  [[nodiscard]] Vector2 advance_velocity(LegId leg) noexcept;
  void search(GenghisLeg& leg, double floor) const noexcept;

  GenghisModel model_;
  GenghisParams params_;
  double sense_of_motion_;  ///< +1 forward, −1 backward
  gait_state::GaitMemory memory_;
  GenghisRecord record_;
};

}  // namespace hexagait::sim2d
