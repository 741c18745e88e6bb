// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/urdf/detail/robot_tree.hpp>

namespace hexagait {

/// Recognises a leg from where its joint axes and its foot are with all joints zero, whatever the
/// signs and zeros of the joints.
///
/// It is yaw-pitch-pitch if, within 1e-4 (rad, or m), it has three joints; the yaw axis parallel to
/// z of the body; both pitch axes horizontal and parallel to each other; the foot in the vertical
/// plane that contains the yaw axis and is normal to the pitch axes; no link of zero length except
/// the coxa. Any other leg is serial.
///
/// Derived of a yaw-pitch-pitch leg:
///  - x_H, outwards in that plane: from the yaw axis to the hip-pitch axis; if these meet (coxa =
///  0),
///    towards the foot; if it is straight below as well, away from the body's origin. So the
///    canonical yaw is 0 where the robot's own yaw joint is 0, and joint_offset[0] = 0.
///  - y_H = z × x_H, the canonical pitch axis: positive pitch turns x_H downwards.
///  - joint_sign: +1 where the joint's axis is along the canonical one (z, y_H, y_H), else −1.
///  - joint_offset: canonical angles, in (−π, π], that the femur and the knee have at joint zero.
///
/// Of a serial leg: the hip frame, on its first axis where that is nearest to the second, x
/// horizontally outwards: towards the foot, or if that is straight below (or above), to the side of
/// the body on which the hip is.
///
/// Limits, links, axes and points are copied; the workspace is left empty.
/// @pre the chain has 2 to 6 joints, and a foot
[[nodiscard]] LegModel recognise_leg(const SerialChain& chain);

}  // namespace hexagait
