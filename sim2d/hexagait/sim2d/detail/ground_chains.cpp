// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/sim2d/detail/ground_chains.hpp>

namespace hexagait::sim2d::detail {
namespace {

constexpr double kSection = 4.0;  // [m]
constexpr double kBegin = 0.053;  // of section 0: no face of `rough` is at the end of one [m]
constexpr double kAround = 1.0;   // [m]

// Box2D takes no vertices nearer to each other than its slop of 0.005 units.
constexpr float kNearest = 0.01F;

// The surface as Box2D wants it: from right to left, so that it faces up.
std::vector<b2Vec2> vertices(const Terrain2d& terrain, Side side, double x0, double x1) {
  std::vector<b2Vec2> result;
  std::vector<Vector2> profile = terrain.profile(side, x0, x1);
  std::ranges::reverse(profile);
  for (const Vector2& point : profile) {
    const b2Vec2 vertex = units(point);
    if (result.empty() || b2Distance(vertex, result.back()) > kNearest) result.push_back(vertex);
  }
  return result;
}

}  // namespace

GroundChains::GroundChains(b2World& world, const Terrain2d& terrain) : terrain_(terrain) {
  const b2BodyDef definition;
  body_ = world.CreateBody(&definition);
}

void GroundChains::cover(double x) {
  const auto section_at = [](double place) {
    return std::lround(std::floor((place - kBegin) / kSection));
  };
  const long first = section_at(x - kAround), end = section_at(x + kAround) + 1;
  if (first_ == end_) first_ = end_ = first;
  while (end_ < end) lay(end_++);
  while (first_ > first) lay(--first_);
}

void GroundChains::lay(long section) {
  lay(section, Side::left);
  lay(section, Side::right);
}

void GroundChains::lay(long section, Side side) {
  const double x0 = kBegin + static_cast<double>(section) * kSection, x1 = x0 + kSection;
  const std::vector<b2Vec2> line = vertices(terrain_, side, x0, x1);
  const auto beyond = [&](double x) { return units(Vector2(x, terrain_.height_at(side, x))); };
  b2ChainShape chain;
  chain.CreateChain(line.data(), static_cast<int32>(line.size()), beyond(x1 + 0.02),
                    beyond(x0 - 0.02));

  b2FixtureDef fixture;
  fixture.shape = &chain;
  fixture.friction = 1.0F;
  fixture.filter.categoryBits = side == Side::left ? kLeftGround : kRightGround;
  body_->CreateFixture(&fixture);
}

}  // namespace hexagait::sim2d::detail
