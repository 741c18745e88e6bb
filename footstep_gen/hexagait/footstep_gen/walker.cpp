// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/executor/lateness.hpp>
#include <hexagait/executor/tick_motion.hpp>
#include <hexagait/footstep_gen/detail/rear_edge.hpp>
#include <hexagait/footstep_gen/walker.hpp>
#include <hexagait/gait_state/ring.hpp>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/posture/lean.hpp>
#include <limits>

namespace hexagait::footstep_gen {
namespace {

constexpr double kPatience = 1.5;      // of a step all tries of which fail: then it is a deadlock
constexpr double kMorePatience = 2.5;  // times as much of a robot that searches beside its path
constexpr double kMostToCome = 1.0;    // of half a step
constexpr double kMostLean = 0.5;      // of the smallest workspace radius
constexpr double kLeanRate = 3.0;      // of the rate at which the body tilts
// Of the time of a lift: drives that are prompt enough for haste, and for fast descents.
constexpr double kHastyLag = 0.1;
constexpr double kDescendingLag = 0.01;

// What a robot with legs of two joints makes of a crab angle: ahead or back, whichever is nearer.
heading_control::Heading without_crab(const heading_control::Heading& heading) {
  const double ahead = std::abs(heading.crab_angle()) <= 0.5 * std::numbers::pi ? 1.0 : -1.0;
  const auto path = heading_control::Heading::along({ahead * heading.rho(), 0.0}, heading.k());
  return heading.moving() ? path : path.stopped();
}

// The displacement as a pose in the body frame.
Pose pose(const PlanarTwist& displacement) {
  return {rotation_z(displacement.w), {displacement.v.x(), displacement.v.y(), 0.0}};
}

}  // namespace

Walker::Walker(const RobotModel& model, const WalkerParams& params)
    : model_(&model),
      params_(checked(completed(params, model))),
      leg_watch_(model.num_legs()),
      estimator_(model, params_.sensors, params_.tolerance),
      tracker_(params_.tolerance.turn_arm),
      memory_(model.num_legs(), nominal_step_time(params_.executor.swing, params_.step)),
      very_rough_gait_(very_rough_gait(memory_.stepper.longest_step())),
      stance_of_all_(nominal_stance(model)),
      level_(stance_of_all_),
      executor_(model, params_.executor),
      in_place_(model.num_legs()),
      beside_(model.num_legs()) {
  watch_.stop(Fault::not_started);
  record_.fault = watch_.fault();
  record_.targets = executor_.targets();
}

void Walker::set_stepping(const gait_state::StepperParams& stepping) {
  Violations violations("walker");
  check_stepping(violations, stepping);
  violations.throw_if_any();
  params_.stepper = stepping;
}

void Walker::set_stance(const Stance& stance) {
  check_stance(*model_, stance);
  stance_of_all_ = stance;
  recentre();
}

const TickRecord& Walker::tick(PlantStatus status, const Measurement& measurement,
                               const heading_control::HeadingCommand& command) noexcept {
  speed_limit_ = command.speed_limit;
  if (!(speed_limit_ >= 0.0)) stop(Fault::bad_command);
  return step(status, measurement, command.heading);
}

const TickRecord& Walker::tick(PlantStatus status, const Measurement& measurement,
                               const heading_control::Heading& heading) noexcept {
  speed_limit_ = std::numeric_limits<double>::infinity();
  return step(status, measurement, heading);
}

const TickRecord& Walker::step(PlantStatus status, const Measurement& measurement,
                               const heading_control::Heading& heading) noexcept {
  record_.lifts = record_.waits = record_.rule1_violations = LegSet();
  if (!healthy(status, measurement)) return stand_by(measurement), record_;
  estimate();       // joints and contacts → feet, odometry, who stands, how rough the ground is
  steer(heading);   // heading → path of this robot, deviation from it
  find_deadlock();  // nobody gets on: where the body goes instead
  decide();         // gait state: which legs may step; stepper: which do
  command();        // footsteps and motion of the base
  execute();        // executor: set points, joint targets
  ++ticks_;
  return record_;
}

void Walker::start(const Measurement& measurement) {
  StateEstimator estimator(*model_, params_.sensors, params_.tolerance);
  const RobotState state = estimator.start(measurement);  // may throw, so before anything changes
  const Stance of_all = stance_of_all_, level = level_;
  const Executor executor = executor_;  // its reset() keeps the stance and the lost legs
  *this = Walker(*model_, params_);
  stance_of_all_ = of_all;
  executor_ = executor;
  level_ = level;
  executor_.set_stance(level_);
  record_.lost = lost_legs();
  watch_ = {};
  record_.fault = Fault::none;
  estimator_ = estimator;
  record_.measurement = measurement;
  record_.state = state;
  executor_.reset(state);
  record_.targets = executor_.targets();
  record_.legs = executor_.legs();
  record_.footsteps = LegArray<FootstepCommand>(model_->num_legs());
  tracker_.reset({0.0, Vector2::Zero()});
  record_.heading = heading_control::Heading::stop();
  record_.arc = arc_of(record_.heading);
  record_.rear_edge = rear_edge(record_.arc, gait_state::hindmost_edge(model_->num_legs()));
  spread_ = unknown_spread(params_.step);
  felt_spread_ = 0.0;
}

bool Walker::healthy(PlantStatus status, const Measurement& measurement) noexcept {
  const bool go =
      watch_.accepts(status, measurement, *model_, params_.control_dt, params_.late_limit);
  record_.fault = watch_.fault();
  record_.holding = watch_.holding();
  if (go) record_.measurement = measurement;
  return go;
}

// A tick in which nothing is decided.
void Walker::stand_by(const Measurement& measurement) noexcept {
  if (watch_.silent()) {
    executor_.coast(record_.state, params_.control_dt);
    ++ticks_;
  } else {
    executor_.hold();
  }
  record_.targets = executor_.targets();
  record_.base = executor_.base();
  record_.legs = executor_.legs();
  if (watch_.fault() == Fault::not_started && valid(measurement, *model_))
    record_.targets.q = measurement.q;
}

void Walker::estimate() noexcept {
  if (params_.finds_faults) find_faults();
  if (record_.findings.none())
    estimator_.update(record_.state, record_.measurement, executor_, watch_.elapsed());
  else
    estimator_.update(record_.state,
                      leg_watch_.mended(record_.measurement, executor_, record_.state), executor_,
                      watch_.elapsed());
  executor_.sense(record_.state, params_.control_dt);
  if (ticks_ < catches_until_ || loses_footing()) catch_fall();
  // A lost leg has no footprint: that of another one stands for it.
  const LegSet lost = lost_legs();
  for (LegId i = 0; !lost.empty() && i < model_->num_legs(); ++i)
    if (lost.contains(i))
      record_.state.print_O[i] = record_.state.print_O[gait_state::leg_at(0, ring())];
  feel_roughness();
}

// (step 4)
void Walker::feel_roughness() noexcept {
  print_spread_ = height_spread(record_.state.print_O);
  const PlanarTwist& V = record_.base.planar;
  const double speed = V.v.norm() + params_.executor.base.outer_radius * std::abs(V.w);
  const double way = speed * params_.control_dt;
  spread_ = remembered_spread(spread_, print_spread_, way, params_.step);
  felt_spread_ = remembered_spread(felt_spread_, print_spread_, way, params_.step);
  const bool may_change = params_.stepper.stepping == gait_state::Stepping::free && !crawls() &&
                          lost_legs().empty() && !model_->legs[0].has_two_joints();
  record_.very_rough = may_change && very_rough(spread_, params_.step);
  executor_.set_centre_of_mass(balanced_mass());
}

heading_control::PathArc Walker::arc_of(const heading_control::Heading& heading) const noexcept {
  const bool two_joints = model_->legs[0].has_two_joints();
  return path_arc(two_joints ? without_crab(heading) : heading, level_);
}

// The stance leans with the slope that the body is on (posture 7). A crawling robot's body sways instead; legs of two
// joints have no room for it.
void Walker::lean() noexcept {
  if (crawls() || model_->legs[0].has_two_joints()) return;
  const double most = kMostLean * *std::ranges::min_element(level_.radius);
  const Vector2 goal =
      posture::lean(level_.p_BC, executor_.p_BM(), record_.state.X_OB.R.row(2), most);
  const double rate = kLeanRate * params_.executor.base.posture_rate;
  lean_ += decay_share(rate * params_.control_dt) * (goal - lean_);
  Stance stance = level_;
  for (Vector3& centre : stance.p_BC) centre.head<2>() += lean_;
  record_.arc.p_BC = stance.p_BC;
  executor_.set_stance(stance);
}

void Walker::steer(const heading_control::Heading& asked) noexcept {
  record_.refuses = asked.moving() && !may_walk_without(lost_legs(), model_->num_legs());
  const heading_control::Heading heading = record_.refuses ? asked.stopped() : asked;
  if (!(heading == record_.heading)) {
    record_.heading = heading;
    record_.arc = arc_of(heading);
    record_.rear_edge = rear_edge(record_.arc, record_.rear_edge);
    tracker_.follow(record_.arc.per_metre);
  }
  lean();
  record_.deviation = tracker_.update(in_plane(record_.state.X_OB));
  if (model_->legs[0].has_two_joints())
    record_.deviation = heading_control::by_turning(record_.deviation, record_.arc.per_metre,
                                                    params_.tolerance.turn_arm);
}

void Walker::find_deadlock() noexcept {
  if (!params_.resolves_deadlocks || crawls() || model_->legs[0].has_two_joints()) return;
  const SwingParams& swing = params_.executor.swing;
  // A step all tries of which fail, and half of another one; a wave gait may take longer from step to step.
  double patience = kPatience * (nominal_step_time(swing, params_.step) +
                                 swing.max_retreats * (swing.retreat_time + swing.transfer_time));
  const gait_state::StepperParams& gait = gait_here();
  if (gait.stepping == gait_state::Stepping::wave)
    patience = std::max(patience, memory_.stepper.period(gait));
  if (beside_.any()) patience *= kMorePatience;
  const int n = model_->num_legs();
  DeadlockInput in{.time = time(),
                   .walks = record_.heading.moving() && speed_limit_ > 0.0,
                   .path = record_.arc.per_metre,
                   .X_OB = record_.state.X_OB,
                   .p_BF = LegArray<Vector3>(n),
                   .p_BC = stance().p_BC,
                   .standing = executor_.support(),
                   .failing = without(LegSet::all(n), executor_.support() | lost_legs()),
                   .lost = lost_legs(),
                   .progress = 0.5 * std::min(params_.step.stroke, speed_limit_ * patience),
                   .patience = patience,
                   .arm = params_.executor.base.outer_radius};
  for (LegId i = 0; i < n; ++i) {
    const LegLane& lane = executor_.legs()[i];
    in.p_BF[i] = lane.p_BF;
    if (lane.retreats >= swing.max_retreats && !lost_legs().contains(i)) in.failing.insert(i);
  }
  record_.escape = deadlock_.update(in);
}

void Walker::decide() noexcept {
  if (crawls()) X_BG_ = pose(record_.deviation);
  record_.gait_input = gait_input(record_.arc, executor_, params_.step, path_pose());
  hold_back(record_.gait_input, record_.escape.held | balance_.first.held());
  record_.gate = crawls() ? gate() : LiftGateDecision{};
  const gait_state::StepConditions conditions{
      .time = time(),
      .rear_edge = record_.rear_edge,
      .walking = walks() && record_.escape.phase != EscapePhase::moves,
      .unsure = executor_.unsure(),
      .steady = [this](LegSet legs) { return steady(legs); },
      .crawls = crawls(),
      .open = record_.gate.open};
  const gait_state::StepDecision decision =
      gait_state::decide(memory_, record_.gait_input, conditions, params_.gait, gait_here());
  record_.gait = decision.gait;
  record_.lifts = decision.lifts;
  record_.waits = decision.waits;
  record_.rule1_violations = decision.rule1_violations;
  note_gain();
  if (!lost_legs().empty() && !crawls()) wait_for_balance();
}

void Walker::command() noexcept {
  learn_holes();
  const StepParams step = steps_here();
  const double half_step = walks() ? 0.5 * step.stroke : 0.0;
  record_.path_to_come = path_to_come(record_.arc, executor_, half_step, path_pose());
  // With a leg lost the base may wait for balance, and feet would land too far ahead of it.
  if (!lost_legs().empty())
    record_.path_to_come = std::min(record_.path_to_come, kMostToCome * half_step);

  for (LegId i = 0; i < model_->num_legs(); ++i) {
    if (lost_legs().contains(i)) continue;
    const bool in_air = executor_.legs()[i].phase != LegPhase::support;
    if (!in_air && !record_.lifts.contains(i)) continue;
    double to_come = share_to_come(i) * record_.path_to_come;
    if (executor_.legs()[i].phase == LegPhase::descend)
      to_come = to_come_coming_down(executor_.stance(), i, half_step, to_come, step);
    record_.footsteps[i] = footstep(*model_, executor_.stance(), record_.arc, record_.state, i,
                                    half_step, to_come, step, path_pose());
    if (!crawls()) keep_clear_of_holes(record_.footsteps[i], to_come);
    executor_.command(record_.footsteps[i], record_.state);
  }
  // While it crawls its footholds keep to the path; the body follows them.
  const bool sways = crawls() && walks();
  const Escape& escape = record_.escape;
  PlanarTwist back{sways ? Vector2(Vector2::Zero()) : record_.deviation.v, record_.deviation.w};
  const AskedBalance asked = asked_balance();
  const bool gives_way = !sways && asked.margin > 0.0 && !record_.waits.empty();
  if (gives_way) back.v.setZero();
  if (escape.phase != EscapePhase::none) back = escape.left;
  // A crawling base stays as far inside as the leg waited for: braking takes the zero-moment point out by
  // more than the margin of many legs, and the leg on the other side would lose contact.
  const double margin = sways ? step.lift_margin : asked.base;
  record_.base_auto =
      base_auto(*model_, record_.arc, executor_, record_.state.X_OB, back, step, margin);
  keep_out(record_.base_auto, escape);
  if (sways) sway(record_.base_auto, record_.gate.sway);
  if (gives_way) record_.base_auto.correction.v += way_for_waiting();
  record_.base_auto.max_speed = speed_limit_;
  executor_.command(record_.base_auto);
}

// The steps for the ground that the feet have found.
StepParams Walker::steps_here() const noexcept {
  StepParams step = params_.step;
  // The period of a wave is that of its longest step: shorter ones would only wait.
  const bool wave = gait_here().stepping == gait_state::Stepping::wave;
  const bool slides = model_->legs[0].has_two_joints();
  if (wave || crawls() || slides)
    step.haste = step.descent = step.touchdown = 1.0;
  else
    step = on_slope(on_guessed_ground(step, print_spread_), climb());
  // Feet that slide sideways as they stand catch on what low steps don't clear.
  if (!wave && !slides) step = on_ground(step, spread_);
  // A foot whose drives lag by more of its swing runs into the ground, or seems blocked; one that descends fast
  // is deep in the ground before its contact is known, and throws the others off it.
  const auto prompt = [&](double lag) {
    return 1.0 - lateness(executor_.drive_lag(), lag * params_.executor.swing.lift_time);
  };
  step.haste = 1.0 + (step.haste - 1.0) * prompt(kHastyLag);
  step.descent = 1.0 + (step.descent - 1.0) * prompt(kDescendingLag);
  return holes_.empty() ? on_level_ground(step, spread_, params_.step) : step;
}

// The legs of a wave land one after the other. The fraction of the advance still to come that the
// base will have made when this leg lands: its remaining time over that of the leg that lands last.
double Walker::share_to_come(LegId leg) const noexcept {
  if (gait_here().stepping != gait_state::Stepping::wave || !lost_legs().empty()) return 1.0;
  const gait_state::Stepper& stepper = memory_.stepper;
  const double last = last_lift();
  const double last_left = last + stepper.longest_step(gait_here()) - time();
  const double left = last_left - (last - stepper.lifted_at[leg]);
  return left > 0.0 ? left / last_left : 0.0;
}

void Walker::execute() noexcept {
  executor_.set_staying(beside_steps());
  record_.targets = executor_.advance(record_.state, params_.control_dt);
  if (executor_.failed()) stop(Fault::bad_command);
  record_.base_goal = executor_.base_goal();
  record_.base = executor_.base();
  record_.legs = executor_.legs();
}

void Walker::stop(Fault fault) noexcept {
  watch_.stop(fault);
  record_.fault = watch_.fault();
  executor_.hold();
  record_.targets = executor_.targets();
}

}  // namespace hexagait::footstep_gen
