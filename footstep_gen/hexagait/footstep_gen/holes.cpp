// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/footstep_gen/holes.hpp>
#include <limits>

namespace hexagait::footstep_gen {
namespace {

// Of the radius: so far off a hole a foot on either side of it stands well, and no place is sought behind it.
constexpr double kWellClear = 1.4;

}  // namespace

void Holes::add(const Vector2& p_O) noexcept {
  if (size_ == kPlaces) {
    std::shift_left(places_.begin(), places_.end(), 1);
    --size_;
  }
  places_[static_cast<std::size_t>(size_++)] = p_O;
}

void Holes::forget_beyond(const Vector2& p_O, double distance) noexcept {
  const auto far = [&](const Vector2& hole) { return (hole - p_O).norm() > distance; };
  Vector2* const begin = places_.data();
  size_ = static_cast<int>(std::remove_if(begin, begin + size_, far) - begin);
}

bool Holes::beside(const Vector2& p_O, const Vector2& along_O, double near) const noexcept {
  constexpr double kFar = 6.0, kAhead = 0.2;
  bool ahead = false, behind = false;
  for (const Vector2& hole : places()) {
    const Vector2 way = hole - p_O;
    const double along = along_O.dot(way), across = (way - along * along_O).norm();
    if (way.norm() > kFar * near || across < near) continue;
    ahead = ahead || along > kAhead * near;
    behind = behind || along < kAhead * near;
  }
  return ahead && behind;
}

double Holes::distance(const Vector2& p_O, const Vector2& along_O) const noexcept {
  constexpr double kAcross = 0.05;
  double least = std::numeric_limits<double>::infinity();
  for (const Vector2& hole : places()) {
    const Vector2 way = hole - p_O;
    const double along = along_O.dot(way);
    const double aside = (way - along * along_O).norm();
    if (aside > half_width_) continue;
    const double across = kAcross * aside;
    least = std::min(least, std::sqrt(along * along + across * across));
  }
  return least;
}

Foothold clear_of(const Holes& holes, const Vector2& from, const Vector2& to, const Vector2& end,
                  double radius, const std::optional<Disc>& within) noexcept {
  const auto closer = [&](double share) { return Vector2(from + share * (to - from)); };
  const double way = (to - from).norm();
  const Vector2 along = way > 0.0 ? Vector2((to - from) / way) : Vector2::UnitX();
  const double well = kWellClear * radius;
  const struct {
    Vector2 place;
    double least;  // that it is off all holes
  } choices[] = {{to, well},
                 {end, well},
                 {to, radius},
                 {end, radius},
                 {closer(0.75), radius},
                 {closer(0.5), radius},
                 {closer(0.35), radius},
                 {closer(0.2), radius},
                 {from, radius}};
  Foothold best{to, 0.0};
  for (const auto& [place, least] : choices) {
    if (within && (place - within->centre).norm() > within->radius) continue;
    const double off = holes.distance(place, along);
    if (off >= least) return {place, off};
    if (off > best.off) best = {place, off};
  }
  return best;
}

}  // namespace hexagait::footstep_gen
