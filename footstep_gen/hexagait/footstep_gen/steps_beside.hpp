// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <hexagait/math/geometry.hpp>
#include <hexagait/math/leg.hpp>

namespace hexagait::footstep_gen {

/// How far beside their path the legs of each side step, (step 13). Holes are taken to be ditches, as wide as the robot,
/// until a leg has failed twice along its path. Then its side steps beside the path. A foot that finds ground
/// there, with holes beside it, shows that the ground is stepping stones: the side stays beside its path. If a leg
/// fails at both places, on either side of its path, the hole is a ditch, and so are the next ones.
class StepsBeside {
 public:
  explicit StepsBeside(int legs) : failed_(legs, 0) {}

  /// A foot has found no ground.
  /// @param base_O  where the robot is [m]
  void failed(LegId leg, bool left, const Vector2& base_O) noexcept {
    if (ditches_ || ++failed_[leg] % kTries != 0) return;
    place_[left] = (place_[left] + 1) % kPlaces;
    if (!stones_ && place_[left] > kPlacesAtDitch) {
      place_ = {};
      ditches_ = true;
      ditch_O_ = base_O;
    }
    for (int& failed : failed_) failed = 0;
  }
  /// A foot has landed.
  /// @param beside_holes  there are holes beside it
  void landed(LegId leg, bool left, bool beside_holes) noexcept {
    failed_[leg] = 0;
    stones_ = stones_ || (place_[left] != 0 && beside_holes);
    if (!stones_) place_[left] = 0;
  }
  /// There are no holes any more. That they are ditches is remembered for so long a way [m].
  void forget(const Vector2& base_O, double way) noexcept {
    place_ = {};
    stones_ = false;
    ditches_ = ditches_ && (base_O - ditch_O_).norm() < way;
  }

  /// Does a side step beside its path?
  [[nodiscard]] bool any() const noexcept { return place_[0] != 0 || place_[1] != 0; }
  /// Outwards, as a share of the workspace radius.
  [[nodiscard]] double outwards(bool left) const noexcept {
    constexpr std::array<double, kPlaces> kOut = {0.0, 0.4, -0.4, 0.7, -0.7};
    return kOut[static_cast<std::size_t>(place_[left])];
  }

 private:
  // At each place: the foothold asked for, and the end of the workspace.
  static constexpr int kTries = 2;
  static constexpr int kPlaces = 5, kPlacesAtDitch = 2;

  std::array<int, 2> place_{};  // of the right and the left side
  LegArray<int> failed_;        // since the leg landed, or its side went elsewhere
  Vector2 ditch_O_ = Vector2::Zero();
  bool stones_ = false, ditches_ = false;
};

}  // namespace hexagait::footstep_gen
