// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/action/action_feedback.hpp>
#include <hexagait/script/leg_planner.hpp>

namespace hexagait {

/// Sets what is kDerived to what follows from the robot's model.
[[nodiscard]] PlannerParams completed(PlannerParams params, const RobotModel& model);

/// A step, resolved into plans.
struct StepPlan {
  LegSet moving;     ///< legs with a motion
  LegSet commanded;  ///< of these, those that need their plan legs[i]
  LegArray<LegPlan> legs;
  bool moves_base = false;
  BasePlan base;
  double duration = 0.0;      ///< of the step, load transfer included [s]
  Cause cause = Cause::none;  ///< why the step cannot be executed
  LegId leg = -1;             ///< leg that causes it; -1: none
  StancePose stance;          ///< of the last BaseAuto
};

/// Resolves the commands of a step into plans over time: frames, durations, pose adaptation. A
/// value: a copy has the same capacity.
class StepPlanner {
 public:
  StepPlanner(const RobotModel& model, const PlannerParams& params);
  StepPlanner(const StepPlanner& other) { *this = other; }
  StepPlanner(StepPlanner&&) noexcept = default;
  StepPlanner& operator=(const StepPlanner& other);
  StepPlanner& operator=(StepPlanner&&) noexcept = default;
  ~StepPlanner() = default;

  /// Allocates space for all steps of an action, here and in the executor. Nothing else allocates.
  void reserve(const action::Action& action, Executor& executor);

  /// Resolves a step.
  /// @param next  the following step, or null; BaseAuto prepares for it
  [[nodiscard]] const StepPlan& plan(const action::Step& step, const action::Step* next,
                                     const StepStart& start) noexcept;
  [[nodiscard]] const StepPlan& last() const { return plan_; }

 private:
  struct BaseGoalPose {
    Pose X_OB;
    double duration = 0.0;
    bool ignores_legs = false;
  };
  void plan_legs(const action::Step& step, const StepStart& start) noexcept;
  void refuse_to_tip(const action::Step& step, const StepStart& start) noexcept;
  void plan_base(const action::Step& step, const action::Step* next,
                 const StepStart& start) noexcept;
  void keep_places(const StepStart& start) noexcept;
  void refuse_what_is_not_finite() noexcept;
  [[nodiscard]] double time_of(LegId leg, const StepStart& start) const noexcept;
  [[nodiscard]] BaseGoalPose base_goal(const action::Step& step, const action::Step* next,
                                       const StepStart& start, const Pose& from) noexcept;
  [[nodiscard]] Pose best_stance(const action::BaseAuto& command, const action::Step& step,
                                 const action::Step* next, const StepStart& start) noexcept;
  [[nodiscard]] StanceProblem feet_at_the_end(const StepStart& start) const noexcept;
  void set_stance(StanceProblem& problem, const action::BaseAuto& command, LegSet lifted,
                  LegSet ignored, const StepStart& start) const noexcept;
  [[nodiscard]] Twist end_twist(const action::Step& step, const action::Step* next,
                                const StepStart& start, const Pose& from) const noexcept;
  [[nodiscard]] BaseKnot first_goal(const action::Step& step, const action::Step& before,
                                    const BaseKnot& from, const StepStart& start) const noexcept;

  PlannerParams params_;
  StepPlan plan_;
  std::vector<FootKnot> foot_knots_;
  std::vector<BaseKnot> base_knots_;
  std::optional<double> height_;  ///< of the last BaseAuto [m]
};

}  // namespace hexagait
