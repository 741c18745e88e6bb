// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstdlib>
#include <testing/kinematic_pursuit.hpp>

// Laws that hold whatever the path, the pose and the way to face.

namespace hexagait::path_following {
namespace {

using heading_control::Heading;
using testing::Follower;

double between(int least, int most, double unit) {
  return unit * *rc::gen::inRange(least, most + 1);
}

FacingRule any_facing() {
  const int kind = *rc::gen::inRange(0, 3);
  if (kind == 2) return {Facing::car, 0.0};
  return {kind == 0 ? Facing::along : Facing::fixed, between(-314, 314, 0.01)};
}

// Points about 1 m apart, each of which bends the path by less than 115°.
std::vector<Waypoint> any_points() {
  std::vector<Waypoint> points = {{{0.0, 0.0}}};
  double direction = between(-300, 300, 0.01);
  const int count = *rc::gen::inRange(1, 6);
  for (int k = 0; k < count; ++k) {
    points.push_back({points.back().p_P + between(70, 130, 0.01) * unit_vector(direction)});
    direction += between(-200, 200, 0.01);
  }
  return points;
}

struct Scene {
  std::vector<Waypoint> points;
  Shape shape;
  FacingRule facing;
  double L;
  PlanarPose X_PB;
  PathProgress progress;

  [[nodiscard]] PathTask task() const { return {Path(points, shape, false), facing, 1, L}; }
};

Scene any_scene() {
  Scene scene{any_points(),
              *rc::gen::element(Shape::lines, Shape::spline),
              any_facing(),
              between(10, 50, 0.01),
              {between(-314, 314, 0.01), {}},
              {}};
  scene.progress.on_path = true;
  scene.progress.s = between(0, 100, 0.01) * scene.task().path.length();
  scene.X_PB.shift = scene.task().path.at(scene.progress.s) +
                     Vector2(between(-50, 50, 0.01), between(-50, 50, 0.01)) + Vector2(1e-4, 2e-4);
  return scene;
}

Heading command(const Scene& scene) {
  return pursue(scene.progress, scene.task(), scene.X_PB, 0.0).command.heading;
}

// The span of each piece of a spline: rounding may make a piece more or less.
std::vector<std::size_t> pieces(const Scene& scene) {
  std::vector<std::size_t> spans;
  const PathTask task = scene.task();
  for (const Path::Piece& piece : task.path.pieces()) spans.push_back(piece.waypoint);
  return spans;
}

void expect_close(const Heading& a, const Heading& b) {
  RC_ASSERT(std::abs(a.rho() - b.rho()) < 1e-6);
  RC_ASSERT(std::abs(a.k() - b.k()) < 1e-6);
  RC_ASSERT(a.rho() * std::abs(wrap_angle(a.crab_angle() - b.crab_angle())) < 1e-6);
}

bool check_law(void (*law)()) {
  setenv("RC_PARAMS", "seed=7 max_success=400", 0);
  return rc::check(law);
}

// What is turned by π jumps from one side to the other.
bool is_on_a_seam(const Scene& scene) {
  const PathTask task = scene.task();
  const Pursuit now = pursue(scene.progress, task, scene.X_PB, 0.0);
  const double ahead = now.progress.s + scene.L;
  const Vector2 chord = now.goal_P - scene.X_PB.shift;
  const double facing = wrap_angle(facing_at(task, ahead) - scene.X_PB.angle);
  const double off = wrap_angle(portable::atan2(chord.y(), chord.x()) - task.path.direction(ahead));
  return std::abs(std::abs(facing) - std::numbers::pi) < 1e-3 ||
         std::abs(std::abs(off) - std::numbers::pi) < 1e-3 || chord.norm() < 1e-3;
}

TEST(PursuitLaw, DoesNotDependOnWhereThePathLies) {
  EXPECT_TRUE(check_law([] {
    const Scene scene = any_scene();
    RC_PRE(!is_on_a_seam(scene));
    const PlanarPose X = {between(-314, 314, 0.01), {between(-9, 9, 1.0), between(-9, 9, 1.0)}};
    Scene moved = scene;
    for (Waypoint& point : moved.points) point.p_P = X * point.p_P;
    moved.X_PB = X * scene.X_PB;
    if (moved.facing.kind == Facing::fixed) moved.facing.angle += X.angle;
    RC_PRE(pieces(scene) == pieces(moved));
    expect_close(command(scene), command(moved));
  }));
}

TEST(PursuitLaw, IsTheSameInTheMirror) {
  EXPECT_TRUE(check_law([] {
    const Scene scene = any_scene();
    RC_PRE(!is_on_a_seam(scene));
    Scene mirror = scene;
    for (Waypoint& point : mirror.points) point.p_P.y() *= -1.0;
    mirror.X_PB = {-scene.X_PB.angle, {scene.X_PB.shift.x(), -scene.X_PB.shift.y()}};
    mirror.facing.angle *= -1.0;
    const Heading seen = command(mirror);
    const Vector2 v = seen.rho() * unit_vector(-seen.crab_angle());
    const Heading back = seen.rho() > 0.0 ? Heading::along(v, -seen.k())
                                          : Heading::spin(seen.turn() == heading_control::Turn::ccw
                                                              ? heading_control::Turn::cw
                                                              : heading_control::Turn::ccw);
    expect_close(command(scene), back);
  }));
}

TEST(PursuitLaw, ScalesWithTheRobot) {
  EXPECT_TRUE(check_law([] {
    const Scene scene = any_scene();
    RC_PRE(!is_on_a_seam(scene));
    constexpr double kScale = 0.1;
    Scene small = scene;
    for (Waypoint& point : small.points) point.p_P *= kScale;
    small.X_PB.shift *= kScale;
    small.L *= kScale;
    small.progress.s *= kScale;
    RC_PRE(pieces(scene) == pieces(small));
    const Heading a = command(scene), b = command(small);
    RC_ASSERT(std::abs(a.rho() - 0.0) < 1e-12 || std::abs(a.curvature() - kScale * b.curvature()) <
                                                     1e-6 * (1.0 + std::abs(a.curvature())));
    RC_ASSERT(a.rho() * std::abs(wrap_angle(a.crab_angle() - b.crab_angle())) < 1e-6);
  }));
}

// From 0.6 m beside it and any facing, within ten look-aheads: on the path and facing as it is to.
TEST(PursuitLaw, ConvergesToALineAndACircle) {
  EXPECT_TRUE(check_law([] {
    const double radius = between(8, 40, 0.1);
    const bool straight = *rc::gen::arbitrary<bool>();
    const FacingRule facing = any_facing();
    Follower follower{
        .task = {straight ? testing::line(100.0) : testing::circle(radius), facing, 9, 0.3}};
    follower.progress.on_path = true;
    follower.progress.s = 1.0;
    follower.X_PB = {between(-314, 314, 0.01),
                     follower.task.path.at(1.0) + Vector2(0.0, between(-60, 60, 0.01))};
    follower.follow(3000);
    RC_ASSERT(!follower.progress.arrived);
    RC_ASSERT(follower.off() < 0.005);
    RC_ASSERT(follower.off_facing() < 0.03);
  }));
}

// Every path of these is walked to its end, however it begins.
TEST(PursuitLaw, ArrivesAtTheEndOfEveryPath) {
  EXPECT_TRUE(check_law([] {
    const Scene scene = any_scene();
    Follower follower{.task = scene.task(), .X_PB = scene.X_PB};
    follower.follow(10'000);
    RC_ASSERT(follower.progress.arrived);
  }));
}

}  // namespace
}  // namespace hexagait::path_following
