// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <hexagait/footstep_gen/detail/kinematic_walk.hpp>
#include <hexagait/heading_control/twist.hpp>
#include <numbers>
#include <set>
#include <testing/argos.hpp>
#include <testing/control_period.hpp>
#include <vector>

// Steps and speed on level ground, and as asked.

namespace hexagait::footstep_gen::walker_steps_test {
namespace {

using heading_control::Heading;
using hexagait::testing::argos;
using hexagait::testing::kDt;
using Walk = KinematicWalk;

// (step 2, 4) Level up to x = 2 m, then in cells of 0.3 m that are 0 or 8 cm high: more than the half of 10 cm
// that the steps before have saved.
TEST(Walker, TakesLowerStepsOnLevelGround) {
  Walk walk(argos(), 0.0);
  walk.plant.ground = [](const Vector2& p_O) {
    const double along = 2.0 * std::numbers::pi * std::max(0.0, p_O.x() - 2.0) / 0.6;
    return 0.04 *
           (1.0 - std::cos(along));  // smooth: no foot stands on an edge, from which it would fall
  };
  const StepParams& step = walk.walker.params().step;
  const auto footsteps = [&walk](double from, double to) {
    std::vector<FootstepCommand> steps;
    for (int k = 0; k < 30000 && walk.place().x() < to; ++k) {
      const TickRecord& record = walk.tick(Heading::straight(0.0));
      for (LegId i = 0; i < 6; ++i)
        if (record.lifts.contains(i) && walk.place().x() > from)
          steps.push_back(record.footsteps[i]);
    }
    return steps;
  };
  for (const FootstepCommand& taken : footsteps(-1.0, 0.05))
    EXPECT_NEAR(taken.profile_height, step.height, 0.1 * step.height) << "of unknown ground";
  const std::vector<FootstepCommand> level = footsteps(1.0, 1.3);
  ASSERT_GT(level.size(), 3U);
  for (const FootstepCommand& taken : level)
    EXPECT_NEAR(taken.profile_height, (step.level_height - 0.12) * step.height, 1e-3);
  const std::vector<FootstepCommand> rough = footsteps(2.8, 3.6);
  ASSERT_GT(rough.size(), 8U);
  for (const FootstepCommand& taken : rough)
    EXPECT_GE(taken.profile_height, step.height) << "of leg " << taken.leg;
}

// (step 3), (step 10) Once it knows that the drives do not lag. A wave's body follows its swings: it does without.
TEST(Walker, SwingsInHasteOnLevelGround) {
  const auto hastes = [](const WalkerParams& params) {
    Walk walk(argos(), 0.0, 0, params);
    std::set<double> found;
    for (int k = 0; k < 2000; ++k) {
      const TickRecord& record = walk.tick(Heading::straight(0.0));
      for (LegId i = 0; i < 6; ++i)
        if (k > 1000 && record.lifts.contains(i)) found.insert(record.footsteps[i].haste);
    }
    return found;
  };
  const double haste = Walk(argos(), 0.0).walker.params().step.haste;
  ASSERT_GT(haste, 1.0);
  for (const double found : hastes({})) EXPECT_NEAR(found, 1.0 + 1.35 * (haste - 1.0), 0.01);
  WalkerParams wave;
  wave.stepper = {.stepping = gait_state::Stepping::wave, .duty_factor = 0.6};
  EXPECT_EQ(hastes(wave), std::set{1.0});
}

// (step 10) On level ground a foot on its way down aims inside its workspace. Before it aims beyond: the base has yet to come.
TEST(Walker, AimsInsideTheWorkspaceOfAFootThatComesDown) {
  const RobotModel robot = argos();
  for (const double crab : {0.0, 1.0, 0.5 * std::numbers::pi}) {
    Walk walk(robot, 0.0);
    int inside = 0, beyond = 0;
    LegSet down;
    for (int k = 0; k < 3000; ++k) {
      const TickRecord& record = walk.tick(Heading::straight(crab));
      for (LegId i = 0; i < 6; ++i) {
        const LegPhase phase = record.legs[i].phase;
        const bool was_down = down.contains(i);  // when this footstep was commanded
        down.set(i, phase == LegPhase::descend);
        if (k < 1500 || (!was_down && phase != LegPhase::transfer)) continue;
        const Vector3 p_BT = record.state.X_OB.inverse() * record.footsteps[i].p_OT;
        const double off = (p_BT - robot.legs[i].p_BC).head<2>().norm();
        const double radius = robot.legs[i].workspace_radius;
        if (was_down) {
          ++inside;
          EXPECT_LE(off, radius + 1e-3) << crab;
        } else if (off > radius) {
          ++beyond;
        }
      }
    }
    EXPECT_GT(inside, 100);
    EXPECT_GT(beyond, 100);
  }
}

// A velocity command is a path and a limit of the speed along it.
TEST(Walker, KeepsToTheSpeedOfAVelocityCommand) {
  Walk walk(argos());
  const auto stance = nominal_stance(argos());
  const heading_control::HeadingCommand slow =
      heading_control::from_twist({{0.1, 0.0}, 0.0}, stance);
  double fastest = 0.0;
  for (int k = 0; k < 5000; ++k) {
    const TickRecord& record = walk.walker.tick(PlantStatus::fresh, walk.plant.measurement, slow);
    walk.plant.follow(record, kDt);
    fastest = std::max(fastest, record.base.planar.v.norm());
  }
  const BaseParams& base = walk.walker.params().executor.base;
  EXPECT_LT(fastest, 0.1 * 1.001 + base.correction_speed) << "and a little for the correction";
  EXPECT_NEAR(walk.plant.X_OB.p.x(), 1.0, 0.1);
}

}  // namespace
}  // namespace hexagait::footstep_gen::walker_steps_test
