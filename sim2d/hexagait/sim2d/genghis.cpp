// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <bit>
#include <cmath>
#include <ctime>
#include <hexagait/gait_state/ring.hpp>
#include <hexagait/gait_state/tripod_gait.hpp>
#include <hexagait/sim/fnv1a.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/sim2d/genghis.hpp>
#include <hexagait/text/violations.hpp>

namespace hexagait::sim2d {
namespace {

constexpr double kSettling = 0.3;        // the robot stands for so long before it walks [s]
constexpr double kStuckTime = 30.0;      // without kStuckProgress [s]
constexpr double kStuckProgress = 0.02;  // [m]
constexpr double kFallPitch = std::numbers::pi / 3.0;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void check(const GenghisTrial& trial, const GenghisModel& model) {
  Violations violations("Genghis");
  const auto require = [&](bool right, const char* name, double value, const char* words) {
    if (!right) violations.add(name, in_words(value) + "; it must be " + words);
  };
  require(trial.seconds > 0.0 && trial.seconds <= 86400.0, "seconds", trial.seconds,
          "more than 0 and at most 86400");
  require(trial.distance > 0.0, "distance", trial.distance, "more than 0");
  require(0.0 <= trial.random_posture && trial.random_posture <= model.workspace_radius,
          "random_posture", trial.random_posture, "from 0 to 0.05 m, the radius of the workspaces");
  violations.throw_if_any();
}

/// Feet at their workspace centres, displaced at random along the ground.
LegArray<GenghisJoints> posture(const GenghisModel& model, double spread, std::uint64_t seed) {
  RandomSequence random{.seed = seed, .stream = RandomStream::posture};
  LegArray<GenghisJoints> q(kGenghisLegs);
  for (LegId i = 0; i < kGenghisLegs; ++i)
    q[i] = joints_for(model, i, centre(model, i) + Vector2(random.uniform(-spread, spread), 0.0));
  return q;
}

/// Judges a walk by the truth, tick by tick.
class Judge {
 public:
  Judge(const GenghisTrial& trial, const GenghisTruth& truth)
      : dt_(trial.control_dt),
        sense_(trial.backward ? -1.0 : 1.0),
        start_(truth.p_WB.x()),
        lifted_at_(kGenghisLegs, 0.0) {
    summary_.height_min = summary_.height_max = truth.p_WB.y();
    summary_.state_hash = kFnv1aBasis;
    for (const GenghisFoot& foot : truth.feet) slip_before_ += foot.slip_path;
  }

  void observe(const GenghisRecord& record, const GenghisTruth& truth) {
    summary_.seconds += dt_;
    summary_.distance = sense_ * (truth.p_WB.x() - start_);
    watch_body(truth);
    watch_legs(record, truth);
    hash(record, truth);
  }

  [[nodiscard]] bool over() const { return summary_.fell || summary_.stuck; }
  [[nodiscard]] double distance() const { return summary_.distance; }

  [[nodiscard]] GenghisSummary summary() const {
    GenghisSummary s = summary_;
    s.speed = s.seconds > 0.0 ? s.distance / s.seconds : 0.0;
    s.slip_mean = s.steps > 0 ? slip_ / s.steps : 0.0;
    std::vector<double> times = step_times_;
    std::ranges::sort(times);
    const double step_time = times.empty() ? 0.0 : times[times.size() / 2];
    s.tripod_after_steps = gait_state::first_tripod_gait(lifts_, kGenghisLegs, step_time);
    return s;
  }

 private:
  void watch_body(const GenghisTruth& truth) {
    summary_.pitch_max = std::max(summary_.pitch_max, std::abs(truth.pitch));
    summary_.height_min = std::min(summary_.height_min, truth.p_WB.y());
    summary_.height_max = std::max(summary_.height_max, truth.p_WB.y());
    summary_.fell = summary_.fell || !truth.finite || std::abs(truth.pitch) > kFallPitch;
    if (truth.body_touches_ground) summary_.body_contact_time += dt_;
    idle_ += dt_;
    if (summary_.distance > farthest_ + kStuckProgress) {
      farthest_ = summary_.distance;
      idle_ = 0.0;
    }
    summary_.stuck = summary_.stuck || idle_ > kStuckTime;
  }

  void watch_legs(const GenghisRecord& record, const GenghisTruth& truth) {
    LegSet in_air;
    double slip = 0.0;
    for (LegId i = 0; i < kGenghisLegs; ++i) {
      const GenghisLeg& leg = record.legs[i];
      if (record.decision.lifts.contains(i)) {
        lifts_.push_back({i, truth.time});
        lifted_at_[i] = truth.time;
      }
      if (leg.touched_down) step_times_.push_back(truth.time - lifted_at_[i]);
      summary_.contact_losses += leg.lost;
      summary_.blocked += leg.blocked;
      summary_.searches += leg.searched;
      in_air.set(i, !truth.feet[i].in_contact);
      slip += truth.feet[i].slip_path;
    }
    slip_ = slip - slip_before_;
    summary_.steps += record.decision.lifts.size();
    summary_.rule1_violations += record.decision.rule1_violations.size();
    if (gait_state::breaks_rule_1(in_air, kGenghisLegs)) summary_.neighbour_flight += dt_;
  }

  void hash(const GenghisRecord& record, const GenghisTruth& truth) {
    const auto add = [this](double value) {
      summary_.state_hash = fnv1a(std::bit_cast<std::uint64_t>(value), summary_.state_hash);
    };
    for (const double value : {truth.p_WB.x(), truth.p_WB.y(), truth.pitch}) add(value);
    for (const GenghisJoints& q : record.measurement.q) {
      add(q.swing);
      add(q.lift);
    }
  }

  double dt_, sense_, start_;
  double slip_before_ = 0.0, slip_ = 0.0, idle_ = 0.0, farthest_ = 0.0;
  LegArray<double> lifted_at_;
  std::vector<double> step_times_;
  std::vector<gait_state::TimedLift> lifts_;
  GenghisSummary summary_;
};

}  // namespace

GenghisSummary run_genghis(const GenghisTrial& trial, const GenghisObserver& observer,
                           const std::atomic<bool>* stop) {
  const GenghisModel model;
  check(trial, model);
  GenghisWorldParams world_params;
  world_params.physics_dt = trial.physics_dt;
  world_params.control_dt = trial.control_dt;
  world_params.seed = trial.seed;
  const auto q = posture(model, trial.random_posture, trial.seed);
  GenghisWorld world(model, trial.terrain, world_params, q);

  // Comes to rest on its feet before anything is judged.
  const GenghisTargets standing{q, LegArray<GenghisJoints>(kGenghisLegs)};
  for (double t = 0.0; t < kSettling; t += trial.control_dt) world.write(standing);

  GenghisParams params = trial.controller;
  params.gait = trial.gait;
  params.backward = trial.backward;
  params.control_dt = trial.control_dt;
  GenghisController controller(model, params);
  GenghisMeasurement measurement;
  world.read(measurement);
  controller.start(measurement);

  Judge judge(trial, world.truth());
  const double processor_start = processor_seconds();
  const long ticks = std::lround(std::ceil(trial.seconds / trial.control_dt - 1e-9));
  for (long k = 0; k < ticks; ++k) {
    const GenghisRecord& record = controller.tick(measurement);
    world.write(record.targets);
    judge.observe(record, world.truth());
    if (observer) observer(record, world.truth());
    if (judge.over() || judge.distance() >= trial.distance) break;
    if (stop != nullptr && stop->load()) break;
    world.read(measurement);
  }

  GenghisSummary summary = judge.summary();
  summary.arrived = judge.distance() >= trial.distance;
  const double processor = processor_seconds() - processor_start;
  summary.real_time_factor = processor > 0.0 ? summary.seconds / processor : 0.0;
  return summary;
}

}  // namespace hexagait::sim2d
