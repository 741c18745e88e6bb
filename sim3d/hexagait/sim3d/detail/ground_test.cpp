// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/sim/random.hpp>
#include <hexagait/sim3d/detail/ground.hpp>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace hexagait::sim3d::detail {
namespace {

std::vector<std::string> examples() {
  std::vector<std::string> all = {
      "boxes:0.3",          "step:-0.3",    "stairs:-0.1",       "slope:20deg,100deg+boxes:0.1",
      "ice:0.1+stones:0.4", "arena:5m,0.5", "arena:4m+waves:5cm"};
  for (const TerrainDescription& known : known_terrains())
    if (!known.reads_file) all.emplace_back(known.example);
  return all;
}

// Within 3 cm around a place.
bool is_level(const Terrain& terrain, double x, double y) {
  constexpr double kAround = 0.03;
  const double z = terrain.height_at(x, y);
  for (const double dx : {-kAround, 0.0, kAround})
    for (const double dy : {-kAround, 0.0, kAround})
      if (terrain.height_at(x + dx, y + dy) != z) return false;
  return true;
}

class GroundOfKind : public ::testing::TestWithParam<std::string> {
 protected:
  GroundOfKind() { initialise_ode(); }
};

// The geometry that ODE meets and the function that others ask are two descriptions of one ground.
TEST_P(GroundOfKind, IsMetByARayAtTheHeightOfTheTerrain) {
  Ground ground(Terrain(parse_terrain(GetParam()), 17));
  const GeomPtr ray(dCreateRay(nullptr, 10.0));
  RandomSequence random{.seed = 4};
  for (int k = 0; k < 2000; ++k) {
    const double extent = k % 2 == 0 ? 2.0 : 1000.0;
    const double x = random.uniform(-extent, extent), y = random.uniform(-extent, extent);
    const double from = ground.terrain().height_at(x, y) + 4.0;
    dGeomRaySet(ray.get(), x, y, from, 0.0, 0.0, -1.0);

    std::array<dContactGeom, 8> contacts;
    ASSERT_EQ(ground.collide(ray.get(), contacts), 1) << x << " " << y;
    EXPECT_NEAR(contacts[0].pos[2], ground.terrain().height_at(x, y), 1e-9) << x << " " << y;
  }
}

// The nearest of what a ray meets, from any side: by marching along the height. A heightfield has
// steep faces, and all others vertical ones: the march is right to within its steps.
TEST_P(GroundOfKind, IsMetByAnObliqueRayWhereTheTerrainRisesAboveIt) {
  constexpr double kStep = 0.5e-3, kLongest = 1.5;
  Ground ground(Terrain(parse_terrain(GetParam()), 17));
  const Terrain& terrain = ground.terrain();
  RandomSequence random{.seed = 5};
  int met = 0;
  for (int k = 0; k < 200; ++k) {
    const double x = random.uniform(-3.0, 3.0), y = random.uniform(-3.0, 3.0);
    const Vector3 from(x, y, terrain.height_at(x, y) + random.uniform(0.02, 0.3));
    const double yaw = random.uniform(-3.14, 3.14), down = random.uniform(0.0, 1.2);
    const Vector3 direction(std::cos(down) * std::cos(yaw), std::cos(down) * std::sin(yaw),
                            -std::sin(down));
    double marched = std::numeric_limits<double>::infinity();
    for (double s = 0.0; s <= kLongest && std::isinf(marched); s += kStep) {
      const Vector3 p = from + s * direction;
      if (p.z() < terrain.height_at(p.x(), p.y())) marched = s;
    }
    const double range = ground.range(from, direction, kLongest);
    if (std::isinf(range) || std::isinf(marched)) {
      EXPECT_GT(std::min(range, marched), kLongest - 2.0 * kStep) << k;
    } else {
      ++met;
      // A ray may graze an edge within one step of the march.
      const Vector3 p = from + (range + 1e-6) * direction;
      const bool grazes = range < marched - kStep && terrain.height_at(p.x(), p.y()) >= p.z();
      if (grazes) continue;
      EXPECT_NEAR(range, marched, 2.0 * kStep) << k;
    }
  }
  EXPECT_GT(met, 50);
}

// A ball of radius r whose centre is at height r − d above level ground goes d deep, and the ground
// pushes it upwards.
TEST_P(GroundOfKind, PushesABallUpwards) {
  Ground ground(Terrain(parse_terrain(GetParam()), 17));
  const GeomPtr ball(dCreateSphere(nullptr, 0.02));
  for (int k = 0; k < 50; ++k) {
    const double x = 0.3 * k + 0.15, y = -0.3 * k + 0.15;
    if (!is_level(ground.terrain(), x, y)) continue;
    dGeomSetPosition(ball.get(), x, y, ground.terrain().height_at(x, y) + 0.019);
    std::array<dContactGeom, 8> contacts;
    // One for each of the cells below it, if they are equally high.
    const int count = ground.collide(ball.get(), contacts);
    ASSERT_GE(count, 1);
    for (const dContactGeom& contact : std::span(contacts).first(static_cast<std::size_t>(count))) {
      EXPECT_NEAR(contact.depth, 0.001, 1e-12);
      EXPECT_NEAR(contact.normal[2], 1.0, 1e-12);
    }

    dGeomSetPosition(ball.get(), x, y, ground.terrain().height_at(x, y) + 0.0201);
    EXPECT_EQ(ground.collide(ball.get(), contacts), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, GroundOfKind, ::testing::ValuesIn(examples()));

// A ball whose centre is 19 mm from a plane that rises by 20° along y, 1 mm deep.
TEST(Ground, PushesABallAwayFromASlope) {
  initialise_ode();
  Ground ground(Terrain(parse_terrain("slope:20deg,90deg"), 1));
  const GeomPtr ball(dCreateSphere(nullptr, 0.02));
  const Vector3 up(0.0, -std::sin(0.3490658503988659), std::cos(0.3490658503988659));
  for (const double y : {-8.0, 0.3, 5.0}) {
    const Vector3 p = Vector3(4.0, y, ground.terrain().height_at(4.0, y)) + 0.019 * up;
    dGeomSetPosition(ball.get(), p.x(), p.y(), p.z());
    std::array<dContactGeom, 8> contacts;
    ASSERT_GE(ground.collide(ball.get(), contacts), 1);
    EXPECT_NEAR(contacts[0].depth, 0.001, 1e-6);
    EXPECT_NEAR(contacts[0].normal[1], up.y(), 1e-6);
    EXPECT_NEAR(contacts[0].normal[2], up.z(), 1e-6);
  }
}

// The start pad ends at x = 0.6. A ball on the pad, 1 mm into the face of a higher cell there, is
// pushed back along −x by the face and up by the pad.
TEST(Ground, OfBoxesHasVerticalFaces) {
  initialise_ode();
  const Terrain terrain(TerrainSpec(TerrainKind::boxes, 0.3), 17);
  ASSERT_GT(terrain.level(2, 0), 0.02);
  Ground ground(terrain);
  const GeomPtr ball(dCreateSphere(nullptr, 0.02));
  dGeomSetPosition(ball.get(), 0.581, 0.15, 0.019);
  std::array<dContactGeom, 8> contacts;
  ASSERT_EQ(ground.collide(ball.get(), contacts), 2);
  EXPECT_NEAR(contacts[0].normal[2], 1.0, 1e-12);
  EXPECT_NEAR(contacts[1].normal[0], -1.0, 1e-12);
  EXPECT_NEAR(contacts[1].depth, 0.001, 1e-12);
}

// A block of 10 cm on the plane: a ray from above meets it at its top, and the plane beside it; a
// ball is pushed away from its side.
TEST(Ground, HasBlocksOnIt) {
  initialise_ode();
  const std::array blocks = {Block{{2.0, 1.0, 0.05}, {0.2, 0.4, 0.1}}};
  Ground ground(Terrain(TerrainSpec(), 1), blocks);
  const GeomPtr ray(dCreateRay(nullptr, 10.0)), ball(dCreateSphere(nullptr, 0.02));
  std::array<dContactGeom, 8> contacts;
  for (const auto& [x, y, top] : {std::tuple{2.0, 1.0, 0.1}, {2.09, 1.19, 0.1}, {2.11, 1.0, 0.0}}) {
    dGeomRaySet(ray.get(), x, y, 5.0, 0.0, 0.0, -1.0);
    const int count = ground.collide(ray.get(), contacts);
    double highest = -1.0;
    for (const dContactGeom& contact : std::span(contacts).first(static_cast<std::size_t>(count)))
      highest = std::max(highest, contact.pos[2]);
    EXPECT_NEAR(highest, top, 1e-12) << x << " " << y;
  }
  EXPECT_NEAR(ground.range({1.5, 1.0, 0.05}, Vector3::UnitX(), 1.0), 0.4, 1e-12);
  EXPECT_EQ(ground.range({1.5, 1.0, 0.05}, Vector3::UnitX(), 0.39),
            std::numeric_limits<double>::infinity());
  dGeomSetPosition(ball.get(), 1.881, 1.0, 0.05);
  ASSERT_EQ(ground.collide(ball.get(), contacts), 1);
  EXPECT_NEAR(contacts[0].depth, 0.001, 1e-12);
  EXPECT_NEAR(contacts[0].normal[0], -1.0, 1e-12);
}

// The ray is looked at in pieces of 0.25 m. A face where one ends is met too: if a ray began behind it,
// by rounding, it would meet the far side.
TEST(Ground, IsMetByARayThatEndsAtItsFaceByRounding) {
  initialise_ode();
  RandomSequence random{.seed = 3};
  for (int k = 0; k < 1000; ++k) {
    const double face = random.uniform(-3.0, 3.0), yaw = random.uniform(-0.5, 0.5);
    const std::array blocks = {Block{{face + 0.5, 0.0, 0.5}, {1.0, 20.0, 1.0}}};
    Ground ground(Terrain(TerrainSpec(), 1), blocks);
    const Vector3 direction(std::cos(yaw), std::sin(yaw), 0.0);
    const Vector3 from = Vector3(face, 0.0, 0.5) - 0.25 * (1 + k % 3) * direction;
    EXPECT_NEAR(ground.range(from, direction, 2.0), 0.25 * (1 + k % 3), 1e-9);
  }
}

TEST(Ground, PutsNoMoreContactsThanThereIsRoomFor) {
  initialise_ode();
  Ground ground(Terrain(TerrainSpec(TerrainKind::boxes, 0.0), 1));
  const GeomPtr box(dCreateBox(nullptr, 1.0, 1.0, 0.1));
  std::array<dContactGeom, 64> contacts;
  EXPECT_GT(ground.collide(box.get(), contacts), 8);
  EXPECT_EQ(ground.collide(box.get(), std::span(contacts).first(3)), 3);
  EXPECT_EQ(ground.collide(box.get(), std::span(contacts).first(0)), 0);
}

}  // namespace
}  // namespace hexagait::sim3d::detail
