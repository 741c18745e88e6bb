// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/plant/recorded_plant.hpp>
#include <hexagait/script/preview.hpp>
#include <hexagait/text/violations.hpp>

namespace hexagait {
namespace {

// Fraction of a joint's velocity limit that counts as reaching it.
constexpr double kAtLimit = 1.0 - 1e-6;

std::string millimetres(double metres) { return in_words(std::round(1e4 * metres) / 10.0) + " mm"; }

// Position in the file of a leg's command, or else of the base's command, or else of the step.
action::Mark mark_of(const action::Step& step, LegId leg) {
  for (const action::LegCommand& command : step.legs)
    if (leg_motion(command).leg == leg) return command.mark;
  return step.base ? step.base->mark : step.mark;
}

RunnerParams lenient(RunnerParams params) {
  params.sensors = {.joint_feedback = false, .foot_contacts = false};
  params.sequencer.planner.refuses = false;
  return params;
}

// Checks every tick and records problems, once per step and leg.
class Examiner {
 public:
  Examiner(const RobotModel& model, const action::Action& action, const PreviewParams& params,
           Preview& preview)
      : model_(model),
        action_(action),
        narrow_margin_(completed(params.runner.sequencer.planner, model).script.narrow_margin),
        preview_(preview),
        farthest_(model.num_legs()) {
    preview_.least_margin = std::numeric_limits<double>::infinity();
  }

  void look(const ActionRunner& runner) {
    const ActionRecord& record = runner.record();
    const int step = record.feedback.step;
    if (step == 0) return;
    if (step != step_) begin(step, runner.sequencer().plan());
    for (LegId i = 0; i < model_.num_legs(); ++i) look_at_leg(i, runner);
    look_at_margin(record);
  }

  void finish() { end_step(); }

 private:
  void begin(int step, const StepPlan& plan) {
    end_step();
    step_ = step;
    beyond_ = fast_ = LegSet();
    margin_ = std::numeric_limits<double>::infinity();
    if (plan.cause == Cause::out_of_reach)
      note(Finding::Kind::out_of_reach, plan.leg,
           "the base cannot be held where base_auto wants it: the leg does not reach its foot");
    if (plan.cause == Cause::unstable)
      note(Finding::Kind::unstable, plan.leg,
           "the centre of mass is outside the support polygon while this leg is lifted; move the "
           "base first, for example in a step with base_auto alone");
    if (plan.cause == Cause::not_finite)
      note(Finding::Kind::not_finite, plan.leg,
           "a number is not finite, or so large that the motion is not; the action ends here");
    refused_ = plan.cause == Cause::unstable;
    lies_ = lies_ && !plan.moves_base;
  }

  void look_at_leg(LegId leg, const ActionRunner& runner) {
    const LegLane& lane = runner.executor().legs()[leg];
    const bool moves = lane.phase == LegPhase::follow || lane.on_ground();
    if (moves && !runner.executor().reachable(leg)) look_beyond(leg, lane.p_BF);
    if (lane.phase == LegPhase::follow && too_fast(leg, runner.executor().targets()))
      fast_.insert(leg);
  }

  // Told once per step, of the moment in which the foot is farthest from where the leg reaches.
  void look_beyond(LegId leg, const Vector3& p_BF) {
    const LegModel& model = model_.legs[leg];
    const Vector3 p_BR = foot_position(model, inverse_kinematics(model, p_BF).q);
    const double distance = (p_BF - p_BR).norm();
    if (beyond_.contains(leg) && distance <= farthest_[leg].distance) return;
    if (!beyond_.contains(leg)) {
      farthest_[leg].finding = preview_.findings.size();
      note(Finding::Kind::out_of_reach, leg, "");
    }
    beyond_.insert(leg);
    farthest_[leg].distance = distance;
    preview_.findings[farthest_[leg].finding].text =
        where(leg) + "its foot is to be at (" + in_words(p_BF.x()) + ", " + in_words(p_BF.y()) +
        ", " + in_words(p_BF.z()) + ") m in the base, " + millimetres(distance) +
        " beyond where the leg reaches";
  }

  [[nodiscard]] bool too_fast(LegId leg, const JointTargets& targets) const {
    for (int k = 0; k < model_.legs[leg].num_joints(); ++k) {
      const double limit = model_.legs[leg].limits[k].velocity;
      if (std::abs(targets.qd[leg][k]) > kAtLimit * limit) return true;
    }
    return false;
  }

  void look_at_margin(const ActionRecord& record) {
    // Without support the body rests on something else, until it moves.
    lies_ = lies_ || record.desired.support.empty();
    if (lies_) return;
    margin_ = std::min(margin_, record.margin);
    if (record.margin >= preview_.least_margin) return;
    preview_.least_margin = record.margin;
    preview_.least_margin_step = step_;
  }

  void end_step() {
    if (step_ == 0) return;
    for (LegId i = 0; i < model_.num_legs(); ++i)
      if (fast_.contains(i))
        note(Finding::Kind::too_fast, i,
             "a joint would have to exceed its velocity limit; it will lag behind", false);
    if (margin_ < 0.0 && !refused_)
      note(Finding::Kind::unstable, -1,
           "the centre of mass is up to " + millimetres(-margin_) +
               " outside the support polygon; it must be inside");
    else if (margin_ < narrow_margin_)
      note(Finding::Kind::narrow, -1,
           "the stability margin falls to " + millimetres(margin_) + "; it should be at least " +
               millimetres(narrow_margin_),
           false);
  }

  void note(Finding::Kind kind, LegId leg, const std::string& text, bool is_error = true) {
    const action::Step& step = action_.steps[static_cast<std::size_t>(step_ - 1)];
    preview_.findings.push_back({kind, is_error, step_, mark_of(step, leg), where(leg) + text});
  }

  [[nodiscard]] std::string where(LegId leg) const {
    std::string text = "step " + std::to_string(step_);
    if (leg >= 0) text.append(", ").append(model_.legs[leg].name);
    return text + ": ";
  }

  const RobotModel& model_;
  const action::Action& action_;
  double narrow_margin_;  ///< [m]
  Preview& preview_;
  int step_ = 0;
  LegSet beyond_, fast_;  ///< legs already reported in this step
  struct Farthest {
    std::size_t finding = 0;  ///< its index
    double distance = 0.0;    ///< [m]
  };
  LegArray<Farthest> farthest_;  ///< of the legs in beyond_
  double margin_ = 0.0;          ///< least margin in this step [m]
  bool refused_ = false;
  bool lies_ = false;
};

}  // namespace

LegArray<LegJoints> nominal_joints(const RobotModel& model) {
  LegArray<LegJoints> q(model.num_legs());
  for (LegId i = 0; i < model.num_legs(); ++i)
    q[i] = inverse_kinematics(model.legs[i], model.legs[i].p_BC).q;
  return q;
}

Preview preview(const RobotModel& model, const LegArray<LegJoints>& joints,
                const action::Action& action, const PreviewParams& params,
                const std::function<void(const ActionRecord&)>& observe) {
  Preview preview;
  ActionRunner runner(model, lenient(params.runner));
  const double dt = params.runner.control_dt;
  PreviewPlant plant(joints, dt);
  Measurement measurement;
  (void)plant.read(measurement);
  runner.start(measurement, params.rests_on);
  runner.submit(action);
  Examiner examiner(model, action, params, preview);

  const auto most_ticks = static_cast<long>(params.most_seconds / dt);
  long ticks = 0;
  while (!runner.idle() && ticks < most_ticks) {
    ++ticks;
    const PlantStatus status = plant.read(measurement);
    const ActionRecord& record = runner.tick(status, measurement);
    plant.write(record.desired.targets);
    examiner.look(runner);
    if (observe) observe(record);
  }
  examiner.finish();
  preview.result = runner.record().result;
  preview.seconds = static_cast<double>(ticks) * dt;
  if (!runner.idle())
    preview.findings.push_back(
        {Finding::Kind::no_result,
         true,
         0,
         {},
         "the action has not ended after " + in_words(params.most_seconds) + " s"});
  return preview;
}

std::string in_words(const Finding& finding, const std::string& source) {
  std::string line = source;
  for (const int number : {finding.mark.line, finding.mark.column})
    if (number > 0) line.append(":").append(std::to_string(number));
  return line.append(finding.is_error ? ": error: " : ": warning: ").append(finding.text);
}

}  // namespace hexagait
