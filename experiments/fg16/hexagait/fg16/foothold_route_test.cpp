// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <hexagait/balance/support_polygon.hpp>
#include <hexagait/fg16/foothold_route.hpp>
#include <set>
#include <testing/argos.hpp>

namespace hexagait::experiments {
namespace {

using testing::argos;

const sim3d::Terrain& step() {
  static const sim3d::Terrain terrain(sim3d::parse_terrain("step:0.12"), 1);
  return terrain;
}

const Route kLong = {.start = -1.8};

// Those that would be nearer stand just there.
TEST(Footholds, AreOnTheGroundAndAwayFromItsEdge) {
  double nearest = 1.0;
  for (const auto& pair : footholds_along(kLong, argos(), step()))
    for (const Foothold& f : pair) {
      EXPECT_EQ(f.p_MF.z(), step().height_at(f.p_MF.x(), f.p_MF.y()) + argos().foot_radius);
      nearest = std::min(nearest, std::abs(f.p_MF.x() - 0.6));
    }
  EXPECT_NEAR(nearest, 0.05, 1e-9);
}

// On level ground a foothold is where the rule says, and no foot goes farther than a stride; at the
// edge, farther by the gap.
TEST(Footholds, OfALegAreAStrideApartAndEndUnderTheBase) {
  LegArray<double> x(6);
  for (LegId i = 0; i < 6; ++i) x[i] = kLong.start + argos().legs[i].p_BC.x();
  for (const auto& pair : footholds_along(kLong, argos(), step()))
    for (const Foothold& f : pair) {
      EXPECT_GE(f.p_MF.x(), x[f.leg]);
      EXPECT_LE(f.p_MF.x() - x[f.leg], kLong.stride + kLong.edge_gap + 1e-9);
      x[f.leg] = f.p_MF.x();
    }
  for (LegId i = 0; i < 6; ++i) EXPECT_NEAR(x[i], kLong.end + argos().legs[i].p_BC.x(), 1e-9);
}

// Whoever plays the list sees each leg change level once, and be told so.
TEST(Footholds, SayWhenALegChangesLevel) {
  LegArray<double> level(6, argos().foot_radius);
  LegArray<int> changes(6, 0);
  for (const auto& pair : footholds_along(kLong, argos(), step()))
    for (const Foothold& f : pair) {
      EXPECT_EQ(f.from_another_level, f.p_MF.z() != level[f.leg]);
      changes[f.leg] += f.from_another_level ? 1 : 0;
      level[f.leg] = f.p_MF.z();
    }
  for (const int count : changes) EXPECT_EQ(count, 1);
}

// Four feet stand in every step: with the base over the mean of their places it is well within.
TEST(Footholds, LiftTwoLegsThatLeaveTheBaseInsideTheOthers) {
  for (const auto& [first, second] : footholds_along(kLong, argos(), step())) {
    LegSet support = LegSet::all(6);
    support.erase(first.leg);
    support.erase(second.leg);
    LegArray<Vector3> feet(6);
    for (LegId i = 0; i < 6; ++i) feet[i] = argos().legs[i].p_BC;
    EXPECT_EQ(support.size(), 4);
    EXPECT_GT(stability_margin(support_polygon(feet, support), Vector2::Zero()), 0.1);
  }
}

TEST(WalkOn, PreparesForEachPairAndGoesToBothFootholdsInTheMap) {
  const auto footholds = footholds_along({}, argos(), step());
  const action::Action action = walk_on(footholds, "climb");
  ASSERT_EQ(action.steps.size(), 2 * footholds.size() + 2);
  for (const action::Step& s : action.steps) EXPECT_TRUE(s.base.has_value());
  for (std::size_t k = 0; k < footholds.size(); ++k) {
    EXPECT_TRUE(action.steps[2 * k + 1].legs.empty());
    const action::Step& moves = action.steps[2 * k + 2];
    ASSERT_EQ(moves.legs.size(), 2U);
    for (std::size_t j = 0; j < 2; ++j) {
      const auto& footstep = std::get<action::Footstep>(moves.legs[j].motion);
      EXPECT_EQ(footstep.leg, footholds[k][j].leg);
      EXPECT_EQ(footstep.target.frame, kMap);
      EXPECT_EQ(footstep.target.p, footholds[k][j].p_MF);
    }
  }
}

}  // namespace
}  // namespace hexagait::experiments
