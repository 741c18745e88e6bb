// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/heading_control/heading.hpp>
#include <hexagait/math/leg.hpp>
#include <hexagait/math/planar.hpp>
#include <hexagait/model/stance.hpp>

namespace hexagait::heading_control {

/// The path of a heading for a given robot, with a measure of length along it.
///
/// The angle about the turning centre o is 0 on a straight line, and the path of the body's centre
/// is 0 in a turn on the spot. Path length s is therefore the arc length travelled by the workspace
/// centre farthest from o: no workspace centre moves by more than s, and straight lines, arcs and
/// spins have one formula. With Heading's ρ, k, α and u = (−sin α, cos α):
///
///     m = maxᵢ |k cᵢ − ρ u|             (= |k| · farthest |cᵢ − o|; 1 when straight)
///     w = k / m,   v = ρ (cos α, sin α) / m          twist of the body per metre of path
///     M(s) = exp(s (v, w)) = Rz(α) Ty(r) Rz(γ) Ty(−r) Rz(−α),   γ = w s       [PC04] (4)
///
/// Deviation: [PC04] uses γ, which is singular on a straight line.
struct PathArc {
  Heading heading = Heading::stop();
  LegArray<Vector3> p_BC;       ///< workspace centres in the body frame [m]
  PlanarTwist per_metre;        ///< twist of the body, in the body frame [m/m], [rad/m]
  LegArray<Vector2> direction;  ///< tᵢ: unit vector along the motion at cᵢ; 0 where cᵢ = o
  LegArray<double> lag_scale;   ///< metres of path per metre of tangential offset at cᵢ
  LegId farthest = 0;           ///< the leg at whose centre path length is measured
};

/// The path of `heading` for a robot in this stance. A stopped heading has a path too.
[[nodiscard]] PathArc path_arc(const Heading& heading, const Stance& stance) noexcept;

/// M(s), the displacement of the body along the arc by s [m], in the body frame. As the body
/// advances by s, whatever stands on the ground moves by M(−s) in the body frame.
[[nodiscard]] PlanarPose displacement(const PathArc& arc, double s) noexcept;

/// M(s) p: where the point p_B of the body frame goes as the body advances by s [m]; z is kept.
/// A support foot goes to advance(arc, p_BF, −s).
[[nodiscard]] Vector3 advance(const PathArc& arc, const Vector3& p_B, double s) noexcept;

/// Velocity of the body's point p_B per metre of path, in the body frame: v + w z × p [m/m].
[[nodiscard]] inline Vector2 direction_at(const PathArc& arc, const Vector3& p_B) noexcept {
  return arc.per_metre.v + arc.per_metre.w * perpendicular(p_B.head<2>());
}

/// The intended anterior extreme position of a leg: its workspace centre, half a step ahead,
///
///     AEPᵢ = M(s) cᵢ                                                              [PC04] (3)
///
/// so that on landing at AEP and lifting one step later, the foot passes the centre half-way.
/// @param half_step  s [m of path]; at the farthest centre the step is 2 s long
/// @returns position in the body frame [m], with z of the centre; the centre itself if stopped
[[nodiscard]] Vector3 aep(const PathArc& arc, LegId leg, double half_step) noexcept;

/// How far leg i's foot lags behind its workspace centre, in metres of path:
///
///     δᵢ = tᵢ · (cᵢ − pᵢ) · R / max(|cᵢ − o|, ρᵢ)
///
/// with R = |c − o| of the farthest centre and ρᵢ the radius of the leg's workspace. δ > 0: the
/// foot lags. On a straight line the last factor is 1 and δ is the distance along the line.
///
/// Deviation: [PC04] 3.3 takes the angle ∠(pᵢ − o, cᵢ − o), which is the same to first order but
/// unbounded when o lies inside a leg's workspace, where a centimetre would read as metres of lag
/// and that leg would outrank its neighbours for ever. Here, for every r and a foot in its disc,
///
///     |δᵢ| ≤ ρᵢ + L,    L the distance from cᵢ to the farthest centre,
///
/// because R ≤ |cᵢ − o| + L and |cᵢ − pᵢ| ≤ ρᵢ ≤ max(|cᵢ − o|, ρᵢ). Where o crosses cᵢ itself, tᵢ
/// and δᵢ reverse, since forwards becomes backwards there. (The paper gives the sign both ways; a
/// leg that lags more is nearer to the end of its reach and must step first.)
///
/// @param p_BF  foot in the body frame [m]; z is not read
/// @returns [m of path]; 0 where cᵢ = o
[[nodiscard]] inline double lag(const PathArc& arc, LegId leg, const Vector3& p_BF) noexcept {
  const Vector2 offset = (arc.p_BC[leg] - p_BF).head<2>();
  return arc.lag_scale[leg] * arc.direction[leg].dot(offset);
}

/// lag() of every leg.
[[nodiscard]] LegArray<double> lags(const PathArc& arc, const LegArray<Vector3>& p_BF) noexcept;

}  // namespace hexagait::heading_control
