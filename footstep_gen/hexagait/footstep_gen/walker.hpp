// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/state_estimator.hpp>
#include <hexagait/footstep_gen/generator.hpp>
#include <hexagait/footstep_gen/holes.hpp>
#include <hexagait/footstep_gen/lost_legs.hpp>
#include <hexagait/footstep_gen/print_plane.hpp>
#include <hexagait/footstep_gen/roughness.hpp>
#include <hexagait/footstep_gen/steps_beside.hpp>
#include <hexagait/footstep_gen/tick_record.hpp>
#include <hexagait/footstep_gen/walker_params.hpp>
#include <hexagait/gait_state/decide.hpp>
#include <hexagait/gait_state/ring.hpp>
#include <hexagait/heading_control/path_tracker.hpp>
#include <hexagait/heading_control/twist.hpp>
#include <hexagait/plant/plant_watch.hpp>

namespace hexagait::footstep_gen {

/// The walking controller: takes a measurement and a heading and returns joint targets, once per
/// control period. A value; tick() neither throws nor allocates.
///
/// The robot model must outlive the walker.
class Walker {
 public:
  /// @throws InvalidInput  listing all parameters that are out of range
  explicit Walker(const RobotModel& model, const WalkerParams& params = {});
  explicit Walker(const RobotModel&&, const WalkerParams& = {}) = delete;

  /// Takes the robot over in its present stance: all feet are assumed to be on the ground.
  /// @throws InvalidInput  if a joint position is missing or not finite
  void start(const Measurement& measurement);

  /// One control period. Before start() it only holds the joints where they are measured, with
  /// Fault::not_started.
  /// @param status  late: the measurement is ignored and the robot coasts: it goes on and brakes, with
  ///                its limits of acceleration, and then holds; after late_limit it is stopped
  const TickRecord& tick(PlantStatus status, const Measurement& measurement,
                         const heading_control::Heading& heading) noexcept;

  /// The same for a velocity command (heading_control::from_twist()): along its path, no faster than
  /// its limit. A limit that is negative or no number stops it: Fault::bad_command.
  const TickRecord& tick(PlantStatus status, const Measurement& measurement,
                         const heading_control::HeadingCommand& command) noexcept;

  /// Changes the gait from the next tick on: free, wave with a duty factor, or tripod. May be
  /// called between any two ticks; start() keeps it.
  /// @throws InvalidInput  if the duty factor is not from 1/2 to less than 1
  void set_stepping(const gait_state::StepperParams& stepping);

  /// Changes where the feet stand best, and so the height of the body, from the next tick on: the legs
  /// get there with their next steps, the body with its limits of speed. May be called between any two
  /// ticks; start() keeps it.
  /// @throws InvalidInput  if a leg can't stand so; then nothing changes
  void set_stance(const Stance& stance);
  [[nodiscard]] const Stance& stance() const {
    return executor_.stance();
  }  ///< recentred and leant

  /// The leg is lost: cut off, dead, or not to be used. From the next tick on it takes no part; the ring
  /// closes over it, the stance is recentred over the others (stance_without()), and the robot walks on by
  /// the same rules, freely whatever the gait, or stands, if too few are left (may_walk_without()). May be
  /// called between any two ticks; start() keeps it. Does not allocate. Of a leg that there is not, and of
  /// one that is lost already: does nothing.
  void lose_leg(LegId leg) noexcept;
  [[nodiscard]] LegSet lost_legs() const { return executor_.lost(); }

  /// Stops at once until the next start(): velocities are set to 0, set points kept.
  void emergency_stop() noexcept { stop(Fault::emergency_stop); }

  [[nodiscard]] const TickRecord& record() const { return record_; }
  [[nodiscard]] const RobotModel& model() const { return *model_; }
  [[nodiscard]] const WalkerParams& params() const { return params_; }

 private:
  const TickRecord& step(PlantStatus status, const Measurement& measurement,
                         const heading_control::Heading& heading) noexcept;
  bool healthy(PlantStatus status, const Measurement& measurement) noexcept;
  void stand_by(const Measurement& measurement) noexcept;
  void estimate() noexcept;
  void find_faults() noexcept;
  [[nodiscard]] bool stands_level() const noexcept;
  [[nodiscard]] bool loses_footing() const noexcept;
  void catch_fall() noexcept;
  void steer(const heading_control::Heading& heading) noexcept;
  [[nodiscard]] heading_control::PathArc arc_of(
      const heading_control::Heading& heading) const noexcept;
  void find_deadlock() noexcept;
  void decide() noexcept;
  [[nodiscard]] LegSet may_crawl() const noexcept;
  [[nodiscard]] LegSet beside_steps() const noexcept;
  LiftGateDecision gate() noexcept;
  [[nodiscard]] LegSet steady(LegSet legs) const noexcept;
  [[nodiscard]] double last_lift() const noexcept;
  void note_gain() noexcept;
  [[nodiscard]] bool one_at_a_time() const noexcept;
  [[nodiscard]] bool too_soon() const noexcept;
  /// The balance that a leg waits for before it lifts. None: its margin is 0.
  struct AskedBalance {
    double margin = 0.0;  ///< of the centre of mass inside the feet that stay [m]
    double beyond = 0.0;  ///< where the body goes for a leg that waits, of the margin
    double steps = 0.0;   ///< who waits for longer does without [times of a step]
    double base = 0.0;    ///< least that the base keeps from the edges of the support polygon [m]
  };
  [[nodiscard]] AskedBalance asked_balance() const noexcept;
  [[nodiscard]] double late() const noexcept;
  [[nodiscard]] double climb() const noexcept;
  [[nodiscard]] double descent() const noexcept;
  [[nodiscard]] Vector3 balanced_mass() const noexcept;
  [[nodiscard]] double balance_margin() const noexcept;
  void wait_for_balance() noexcept;
  void command() noexcept;
  void execute() noexcept;
  void stop(Fault fault) noexcept;
  [[nodiscard]] double time() const noexcept {
    return static_cast<double>(ticks_) * params_.control_dt;
  }
  [[nodiscard]] gait_state::Ring ring() const noexcept {
    return {model_->num_legs(), executor_.lost()};
  }
  [[nodiscard]] bool crawls() const noexcept { return must_crawl(ring().size()); }
  [[nodiscard]] bool walks() const noexcept {
    return record_.heading.moving() && record_.escape.phase != EscapePhase::gave_up;
  }
  void recentre() noexcept;
  void lean() noexcept;
  [[nodiscard]] Vector2 way_for_waiting() const noexcept;
  void feel_roughness() noexcept;
  void learn_holes() noexcept;
  [[nodiscard]] Vector2 along_path(LegId leg) const noexcept;
  void keep_clear_of_holes(FootstepCommand& step, double to_come) const noexcept;
  [[nodiscard]] bool on_the_left(LegId leg) const noexcept;
  [[nodiscard]] const gait_state::StepperParams& gait_here() const noexcept {
    return record_.very_rough ? very_rough_gait_ : params_.stepper;
  }
  [[nodiscard]] StepParams steps_here() const noexcept;
  [[nodiscard]] const Pose* path_pose() const noexcept { return crawls() ? &X_BG_ : nullptr; }
  [[nodiscard]] double share_to_come(LegId leg) const noexcept;

  const RobotModel* model_;
  WalkerParams params_;
  PlantWatch watch_;
  LegWatch leg_watch_;
  StateEstimator estimator_;
  heading_control::PathTracker tracker_;
  gait_state::GaitMemory memory_;
  gait_state::StepperParams very_rough_gait_;
  Deadlock deadlock_;
  LiftGate gate_;
  BalanceWait balance_;
  double last_gain_ = 0.0;          ///< last lift of a foot behind its workspace centre [s]
  Pose X_BG_;                       ///< see gait_input()
  Stance stance_of_all_;            ///< before any leg was lost
  Stance level_;                    ///< of the legs that there are, on level ground
  Vector2 lean_ = Vector2::Zero();  ///< of the workspace centres from there [m]
  Executor executor_;
  double speed_limit_ = std::numeric_limits<double>::infinity();  ///< along the path [m/s]
  Holes holes_;
  StepsInPlace in_place_;
  StepsBeside beside_;
  PrintPlane print_plane_;     ///< of the last footprints, where holes are known
  double print_spread_ = 0.0;  ///< of the last footprints in height [m]
  double felt_spread_ = 0.0;   ///< of the ground of late, as far as feet have stood on it [m]
  double spread_ = 0.0;        ///< of the ground of late; rough before the first steps [m]
  long catches_until_ = 0;     ///< tick until which it may have to catch itself
  long ticks_ = 0;             ///< number of control periods, late ones too
  TickRecord record_;
};

}  // namespace hexagait::footstep_gen
