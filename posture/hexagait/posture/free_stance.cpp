// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/posture/free_optimum.hpp>
#include <hexagait/posture/free_stance.hpp>

namespace hexagait::posture {

StancePose free_stance(const RobotModel& model, const StanceProblem& problem) {
  const int n = model.num_legs();
  const Pose X_BO = problem.X_OB.inverse();
  LegArray<Vector3> p_BF(n), p_BN(n);
  for (LegId i = 0; i < n; ++i) {
    p_BF[i] = X_BO * problem.p_OF[i];
    p_BN[i] = {model.legs[i].p_BC.x(), model.legs[i].p_BC.y(), -problem.height};
  }
  StancePose stance;
  stance.X_OB = problem.X_OB * free_optimum(p_BF, p_BN, problem.reach);

  const Pose X_NO = stance.X_OB.inverse();
  for (LegId i = 0; i < n; ++i) {
    if (!problem.reach.contains(i)) continue;
    const Vector3 p_NF = X_NO * problem.p_OF[i];
    stance.out_of_reach.set(i, !inverse_kinematics(model.legs[i], p_NF).reachable);
    stance.objective += (p_NF - p_BN[i]).squaredNorm();
  }
  stance.margin = stability_margin(support_polygon(problem.p_OF, problem.support),
                                   (stance.X_OB * model.p_BM).head<2>());
  stance.margin_shrunk = stance.margin < problem.margin;
  return stance;
}

}  // namespace hexagait::posture
