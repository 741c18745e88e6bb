// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/viewer/tasks/performance.hpp>
#include <hexagait/walk/actions/action_check.hpp>

namespace hexagait::viewer {
namespace {

using State = ActionProgress::State;

// The robot has to stand within so many times that a foot may search for the ground.
constexpr double kPatience = 5.0;

// Is the base as good as at rest: so slow that it can brake while a contact is confirmed? On uneven ground it creeps
// on for seconds.
bool rests(const BaseLane& base, const ExecutorParams& params) {
  const Twist V = base.twist();
  return V.v.norm() + params.base.outer_radius * V.w.norm() <=
         params.base.acceleration * params.swing.confirm_time;
}

bool stands(const footstep_gen::Walker& walker) {
  const ExecutorParams& params = walker.params().executor;
  for (const LegLane& lane : walker.record().legs)
    if (!lane.supports(params.swing)) return false;
  return rests(walker.record().base, params);
}

}  // namespace

Performance::Performance(const RobotModel& robot, const RunnerParams& params, action::Action action)
    : runner_(robot, params), action_(std::move(action)) {
  progress_ = {State::halting, 0, static_cast<int>(action_.steps.size()), "", -1};
}

void Performance::end(State state, const char* why, LegId leg) noexcept {
  progress_.state = state;
  progress_.why = why;
  progress_.leg = leg;
}

void Performance::wait_for_stand(const footstep_gen::Walker& walker, PlantStatus status,
                                 const Measurement& measurement) {
  if (!progress_.goes_on()) return;
  if (stops_) return end(State::stopped, "");
  if (walker.record().fault != Fault::none) return end(State::failed, "the robot was stopped");
  waited_ += walker.params().control_dt;
  const bool measured = status == PlantStatus::fresh && valid(measurement, walker.model());
  if (measured && stands(walker)) {
    runner_.start(measurement);
    runner_.submit(std::move(action_));
    runs_ = true;
    progress_.state = State::running;
  } else if (waited_ > kPatience * walker.params().executor.swing.search_time) {
    end(State::failed, "the robot does not come to stand on all its feet");
  }
}

const ActionRecord& Performance::tick(PlantStatus status, const Measurement& measurement,
                                      const Pose& X_WB) {
  if (stops_) runner_.stop();
  runner_.frames().X_OM = runner_.record().state.X_OB * X_WB.inverse();
  runner_.tick(status, measurement);
  report();
  return runner_.record();
}

void Performance::report() noexcept {
  if (!progress_.goes_on()) return;
  const ActionRecord& record = runner_.record();
  if (record.feedback.step > 0) progress_.step = record.feedback.step;
  if (record.fault != Fault::none) return end(State::failed, to_string(record.fault));
  if (!runner_.idle()) return;
  const ActionResult& result = record.result;
  if (result.outcome == Outcome::succeeded) return end(State::done, "");
  if (result.outcome == Outcome::preempted) return end(State::stopped, "");
  end(State::failed, walk::in_words(result.cause), result.leg);
}

// The runner's record shows it at once: what is written next is held.
void Performance::emergency_stop(const Measurement& measurement) noexcept {
  if (progress_.goes_on()) end(State::stopped, "by the emergency stop");
  if (!runs_) return;
  runner_.emergency_stop();
  runner_.tick(PlantStatus::late, measurement);
}

}  // namespace hexagait::viewer
