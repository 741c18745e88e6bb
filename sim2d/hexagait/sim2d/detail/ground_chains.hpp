// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/sim2d/detail/box2d.hpp>
#include <hexagait/sim2d/terrain2d.hpp>

namespace hexagait::sim2d::detail {

/// The ground of both sides as Box2D chains, laid section by section where the robot comes.
class GroundChains {
 public:
  GroundChains(b2World& world, const Terrain2d& terrain);

  /// Sees to it that there is ground at least 1 m to both sides of x [m].
  void cover(double x);

  [[nodiscard]] const Terrain2d& terrain() const { return terrain_; }

 private:
  void lay(long section);
  void lay(long section, Side side);

  Terrain2d terrain_;
  b2Body* body_;
  long first_ = 0, end_ = 0;  ///< sections laid: first_ … end_ − 1
};

}  // namespace hexagait::sim2d::detail
