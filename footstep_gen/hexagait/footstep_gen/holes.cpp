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
  places_[static_cast<std::size_t>(next_)] = p_O;
  next_ = (next_ + 1) % kPlaces;
  size_ = std::min(size_ + 1, kPlaces);
}

void Holes::forget_beyond(const Vector2& p_O, double distance) noexcept {
  Holes near;
  for (int k = 0; k < size_; ++k) {
    const Vector2& hole =
        places_[static_cast<std::size_t>((next_ + kPlaces - size_ + k) % kPlaces)];
    if ((hole - p_O).norm() > distance) continue;
    near.places_[static_cast<std::size_t>(near.next_++)] = hole;
    ++near.size_;
  }
  near.next_ %= kPlaces;
  near.half_width_ = half_width_;
  *this = near;
}

bool Holes::beside(const Vector2& p_O, const Vector2& along_O, double near) const noexcept {
  constexpr double kFar = 6.0, kAhead = 0.2;
  bool ahead = false, behind = false;
  for (int k = 0; k < size_; ++k) {
    const Vector2 way = places_[static_cast<std::size_t>(k)] - p_O;
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
  for (int k = 0; k < size_; ++k) {
    const Vector2 way = places_[static_cast<std::size_t>(k)] - p_O;
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
