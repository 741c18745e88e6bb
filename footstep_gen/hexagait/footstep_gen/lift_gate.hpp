// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/executor/commands.hpp>
#include <hexagait/footstep_gen/neighbours_first.hpp>
#include <hexagait/gait_state/ring.hpp>
#include <limits>

/// Crawling. Six legs that keep rule 1 ([PC04] 3.1) stand on a tripod at least. Four legs that keep
/// it would trot, on two feet. So robots of four legs lift one leg at a time, and a leg
/// waits until the centre of mass is inside the polygon of the feet that stay, by a margin. Until
/// then the base moves there.
namespace hexagait::footstep_gen {

/// Rule 1 alone does not leave three feet on the ground.
[[nodiscard]] constexpr bool must_crawl(int legs) noexcept { return legs < 5; }

struct LiftGateInput {
  LegArray<Vector3> feet;          ///< from the body's origin, in axes with vertical z [m]
  Vector2 p_M = Vector2::Zero();   ///< centre of mass, same axes [m]
  LegSet support;                  ///< legs that stand
  LegSet may_step;                 ///< no neighbour is in the air
  LegArray<double> lag;            ///< δ of the legs [m of path]
  LegArray<double> along;          ///< how far ahead each leg is on the body, along the path [m]
  Vector2 path = Vector2::Zero();  ///< direction in which the base moves; 0: it turns in place
  double margin = 0.0;             ///< least stability margin on the feet that stay [m]
};

struct LiftGateDecision {
  LegSet open;                     ///< the leg that may lift now, or none
  Vector2 sway = Vector2::Zero();  ///< displacement of the base for the leg that is next [m]
};

/// The leg that lifts next, kept until it has lifted or may not step any more. The order of the
/// relations ([PC04] 3.1) is not needed where one leg lifts at a time. The base sways across its
/// path if it can, so that it need not go back. A value.
struct LiftGate {
  LegId next = -1;

  /// Chooses, of the legs that may step and leave three feet behind, the one with
  ///
  ///     most   δ − 0.2 |sway| − 0.02 along                                      (crawl 1)
  ///
  /// : the leg that is farthest back on its path; of such legs one that the base is well placed for;
  /// of such legs a rear one. On a straight path this is the crawl that is known to be the most
  /// stable one: a hind leg, then the fore leg before it, then the other side.
  LiftGateDecision update(const LiftGateInput& in) noexcept;
};

/// Of these legs the one with the greatest lag; −1 if there is none.
[[nodiscard]] LegId hindmost(LegSet legs, const LegArray<double>& lag) noexcept;

/// Of legs that the gait state lets lift, those that leave the centre of mass over three feet or more:
/// all together, else as many as do, the one with the greatest lag first.
/// @param feet, p_M  as in LiftGateInput
/// @param margin     by which it has to be over them [m]
[[nodiscard]] LegSet steady_lifts(const LegArray<Vector3>& feet, const Vector2& p_M, LegSet support,
                                  LegSet legs, const LegArray<double>& lag,
                                  double margin = 0.0) noexcept;

/// Time between two lifts of a ring in which `most` legs are in the air at a time, by which they lift one
/// after the other: a little less than T/most, by which none waits in vain [s].
/// @param step_time  of the last step of each leg [s]
[[nodiscard]] double lift_spacing(const LegArray<double>& step_time, LegSet lost,
                                  int most) noexcept;

struct BalanceWaitInput {
  double time = 0.0;       ///< [s]
  double last_lift = 0.0;  ///< of any leg [s]
  double patience = 0.0;   ///< how long a leg waits before its neighbours step first [s]
  LegSet waits;            ///< legs that may step, but would leave the robot out of balance
  LegSet support;          ///< legs that stand
  gait_state::Ring ring;
};

/// Where a leg waits for balance in vain, its neighbours step first: the line between their feet is the
/// edge that the centre of mass has to pass, and their relations would keep them where they are for good.
/// A value.
struct BalanceWait {
  double since =
      -std::numeric_limits<double>::infinity();  ///< the last lift, or the last leg held [s]
  NeighboursFirst first;                         ///< legs that wait for their neighbours

  /// @returns the legs that are held from now on
  LegSet update(const BalanceWaitInput& in) noexcept;
};

/// The shortest displacement after which the centre of mass is `margin` inside the polygon of these legs,
/// or equally far inside of the edges that matter; 0 over fewer than three [m].
[[nodiscard]] Vector2 way_over(const LegArray<Vector3>& feet, const Vector2& p_M, LegSet legs,
                               double margin) noexcept;

/// The base's motion while it crawls: `sway` besides the path [m, body frame]. The advance neither
/// takes it back nor adds to it, and never goes back along the path: with a leg in the air, the optimum
/// of the three that stand may be behind the base, and on the way there the leg on the other side of the
/// centre of mass would lose its load.
void sway(BaseAutoCommand& base, const Vector2& sway) noexcept;

}  // namespace hexagait::footstep_gen
