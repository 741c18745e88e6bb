// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <hexagait/curves/base_curve.hpp>
#include <hexagait/curves/foot_curve.hpp>
#include <hexagait/curves/joint_curve.hpp>
#include <hexagait/plant/plant.hpp>

namespace hexagait {

/// A motion of one leg over time: what a command of a script is resolved into when its step
/// starts.
struct LegPlan {
  enum class Kind : std::uint8_t {
    foot,    ///< the foot along a curve
    joints,  ///< the joints along a curve
    keep,    ///< no motion
  };
  Kind kind = Kind::keep;
  double duration = 0.0;  ///< [s]
  FootCurve foot;         ///< in odom, or in the body frame
  bool in_body = false;   ///< `foot` is in the body frame
  JointCurve joints;      ///< [rad]
  ControlMode mode = ControlMode::position;
  Vector3 force_O = Vector3::Zero();    ///< of the foot on the world, fed forward [N]
  Vector3 normal_O = Vector3::UnitZ();  ///< of the ground that is expected, unit vector
  bool lands = true;                    ///< the leg becomes a support leg at the end

  /// Is the motion finite at any time?
  [[nodiscard]] bool in_range() const {
    const bool curve = kind == Kind::foot     ? foot.in_range()
                       : kind == Kind::joints ? joints.in_range()
                                              : true;
    return curve && std::abs(duration) <= kLargestMotion && hexagait::in_range(force_O) &&
           hexagait::in_range(normal_O);
  }

  /// Does the leg move with the body?
  [[nodiscard]] bool with_body() const { return kind != Kind::foot || in_body; }
};

/// A motion of the base in odom over time.
struct BasePlan {
  BaseCurve curve;
};

}  // namespace hexagait
