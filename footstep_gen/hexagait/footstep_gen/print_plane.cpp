// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/footstep_gen/print_plane.hpp>
#include <hexagait/posture/plane_fit.hpp>

namespace hexagait::footstep_gen {

PrintPlane plane_through(const LegArray<Vector3>& print_O) noexcept {
  constexpr int kAllDirections = 3;
  const int n = print_O.size();
  Vector3 middle = Vector3::Zero();
  for (const Vector3& print : print_O) middle += print / n;

  // For centres at height 0, posture::plane_fit() is that of the points themselves.
  const posture::PlaneFit fit =
      posture::plane_fit(print_O, LegArray<Vector3>(n, Vector3::Zero()), LegSet::all(n));
  PrintPlane plane{.middle = middle.head<2>(), .height = middle.z()};
  if (fit.rank == kAllDirections) plane.slope = {-fit.pitch, fit.roll};
  for (const Vector3& print : print_O)
    plane.off = std::max(plane.off, std::abs(print.z() - plane.at(print.head<2>())));
  return plane;
}

}  // namespace hexagait::footstep_gen
