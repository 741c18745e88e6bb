// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/walk/actions/action_trial.hpp>
#include <hexagait/walk/referee/detail/state_hash.hpp>
#include <hexagait/walk/referee/referee.hpp>

namespace hexagait::walk {
namespace {

// Judges an action by ground truth.
class ActionReferee {
 public:
  ActionReferee(const RobotModel& model, const GroundTruth& truth)
      : model_(model),
        params_(completed(RefereeParams{}, model)),
        touched_at_(model.num_legs(), truth.time) {
    summary_.height_min = summary_.height_max = truth.X_WB.p.z();
    summary_.state_hash = kFnv1aBasis;
    watch_motion(truth);
  }

  void observe(const ActionRecord& record, const GroundTruth& truth) {
    watch_posture(truth);
    watch_margin(record, truth);
    watch_plan(record, truth);
    watch_motion(truth);
    summary_.state_hash = state_hash(model_, truth, record.measurement, summary_.state_hash);
    const Pose X_OW = X_WO_.inverse();
    summary_.odometry_position = (X_OW * truth.X_WB.p - record.state.X_OB.p).norm();
    summary_.fault = record.fault;
  }

  // Odometry and truth agree where the trial starts.
  void begin(const RobotState& state, const GroundTruth& truth) {
    X_WO_ = truth.X_WB * state.X_OB.inverse();
  }

  [[nodiscard]] const ActionSummary& summary() const { return summary_; }
  ActionSummary& summary() { return summary_; }

 private:
  void watch_posture(const GroundTruth& truth) {
    const Vector3 rpy = roll_pitch_yaw(truth.X_WB.R);
    summary_.tilt_max = std::max({summary_.tilt_max, std::abs(rpy.x()), std::abs(rpy.y())});
    summary_.height_min = std::min(summary_.height_min, truth.X_WB.p.z());
    summary_.height_max = std::max(summary_.height_max, truth.X_WB.p.z());
    const bool hit = truth.base_touches_ground && !touched_ && sinking_ > params_.fall_speed;
    summary_.fell = summary_.fell || hit || !truth.finite || summary_.tilt_max > kFallTilt;
    summary_.base_touched = summary_.base_touched || truth.base_touches_ground;
    summary_.leg_touched = summary_.leg_touched || truth.leg_touches_ground;
  }

  void watch_margin(const ActionRecord& record, const GroundTruth& truth) {
    LegArray<Vector3> p_WF(model_.num_legs());
    LegSet feet;
    for (LegId i = 0; i < model_.num_legs(); ++i) {
      p_WF[i] = truth.feet[i].p_WF;
      if (truth.feet[i].in_contact) touched_at_[i] = truth.time;
      feet.set(i, truth.time - touched_at_[i] < params_.bounce);
    }
    summary_.stands_at_end = !truth.base_touches_ground && feet == LegSet::all(model_.num_legs());
    if (truth.base_touches_ground || feet.empty()) return;
    const double margin =
        stability_margin(support_polygon(p_WF, feet), (truth.X_WB * model_.p_BM).head<2>());
    if (margin >= summary_.margin_min) return;
    summary_.margin_min = margin;
    summary_.margin_step = record.feedback.step;
  }

  void watch_plan(const ActionRecord& record, const GroundTruth& truth) {
    for (const FootTruth& foot : truth.feet)
      summary_.foot_force_max = std::max(summary_.foot_force_max, foot.normal_force);
    if (!record.desired.base_follows) return;
    const Pose X_WD = X_WO_ * record.desired.X_OB;
    const Vector3 off = X_WD.p - truth.X_WB.p;
    const double lean = X_WD.R.col(2).cross(truth.X_WB.R.col(2)).norm();
    summary_.off_plan_height = std::max(summary_.off_plan_height, std::abs(off.z()));
    summary_.off_plan_sideways = std::max(summary_.off_plan_sideways, off.head<2>().norm());
    summary_.off_plan_tilt = std::max(summary_.off_plan_tilt, portable::asin(std::min(1.0, lean)));
  }

  void watch_motion(const GroundTruth& truth) {
    touched_ = truth.base_touches_ground;
    sinking_ = -(truth.X_WB.R * truth.V_WB.v).z();
  }

  const RobotModel& model_;
  RefereeParams params_;
  ActionSummary summary_;
  Pose X_WO_;
  LegArray<double> touched_at_;  ///< when each foot last touched [s]
  bool touched_ = false;
  double sinking_ = 0.0;  ///< [m/s]
};

// Holds the joints where they are.
void hold(Plant& plant, Measurement& measurement, long ticks) {
  const LegArray<LegJoints> zero(measurement.q.size(), LegJoints::Zero());
  const JointTargets targets{measurement.q, zero, zero};
  for (long k = 0; k < ticks; ++k) {
    plant.write(targets);
    plant.read(measurement);
  }
}

// Lets the robot come to rest before anything is judged.
Measurement settled(ActionRunner& runner, Plant& plant, const ActionTrialOptions& options) {
  Measurement measurement;
  plant.read(measurement);
  const auto ticks = std::lround(options.settle / runner.params().control_dt);
  if (options.rests_on == RestsOn::belly) {
    hold(plant, measurement, ticks);
  } else {
    runner.start(measurement);
    PlantStatus status = PlantStatus::fresh;
    for (long k = 0; k < ticks; ++k) {
      plant.write(runner.tick(status, measurement).desired.targets);
      status = plant.read(measurement);
    }
  }
  runner.start(measurement, options.rests_on);
  return measurement;
}

}  // namespace

ActionSummary run_action(ActionRunner& runner, Plant& plant, const GroundTruth& truth,
                         const action::Action& action, const ActionTrialOptions& options,
                         const ActionObserver& observer) {
  const double dt = runner.params().control_dt;
  Measurement measurement = settled(runner, plant, options);
  ActionReferee referee(runner.model(), truth);
  referee.begin(runner.record().state, truth);
  runner.submit(action);

  PlantStatus status = PlantStatus::fresh;
  const auto tick = [&] {
    runner.frames().X_OM = options.localisation ? options.localisation(runner.record(), truth)
                                                : runner.record().state.X_OB * truth.X_WB.inverse();
    const ActionRecord& record = runner.tick(status, measurement);
    plant.write(record.desired.targets);
    referee.observe(record, truth);
    status = plant.read(measurement);
    return record.fault == Fault::none && !referee.summary().fell &&
           (!observer || observer(record, truth));
  };

  // The action, then a rest: does the robot still stand?
  const auto most = std::lround(options.seconds / dt), rest = std::lround(options.rest / dt);
  long ticks = 0;
  bool goes_on = true;
  for (; goes_on && ticks < most && (ticks == 0 || !runner.idle()); ++ticks) goes_on = tick();
  const bool out_of_time = !runner.idle();
  for (long k = 0; goes_on && !out_of_time && k < rest; ++k) goes_on = tick();

  ActionSummary summary = referee.summary();
  summary.result = runner.record().result;
  summary.seconds = static_cast<double>(ticks) * dt;
  summary.out_of_time = out_of_time && goes_on;
  return summary;
}

}  // namespace hexagait::walk
