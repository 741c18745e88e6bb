// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/viewer/display/pose_frame.hpp>

namespace hexagait::viewer {
namespace {

constexpr int kLegs = 4;

// No two numbers are the same, so that what goes to a wrong place is seen.
PoseFrame numbered() {
  PoseFrame f;
  double next = 1.0;
  const auto number = [&] { return next += 0.375; };
  f.flags = PoseFrame::paused | PoseFrame::wave;
  f.fault = 5;
  f.scene = 3;
  f.tick = 70000;
  f.holder = 2;
  f.time = 1e5 + 1e-7;
  f.speed_factor = number();
  f.X_WB.p = {number(), number(), number()};
  f.X_WB.R = rotation({0.3, -0.2, 0.9});
  f.velocity = {{number(), number()}, number()};
  f.rho = number();
  f.k = number();
  f.crab = number();
  f.moving = true;
  f.centre = {number(), number()};
  f.margin = number();
  f.com = {number(), number(), number()};
  f.lateral = number();
  f.path = number();
  f.slip_speed = number();
  f.power = number();
  f.raw = 0x101;
  f.state = 0xA5;
  f.ccn = 3;
  f.type = 4;
  f.priority = LegSet(1);
  f.may_step = LegSet(2);
  f.waits = LegSet(4);
  f.contact = LegSet(8);
  f.support = LegSet(9);
  f.urgent = LegSet(12);
  f.polygon.size = 2;
  f.polygon.vertices[0] = {number(), number()};
  f.polygon.vertices[1] = {number(), number()};
  f.legs = LegArray<LegFrame>(kLegs);
  for (LegFrame& leg : f.legs) {
    leg.p_WF = {number(), number(), number()};
    leg.p_WT = {number(), number(), number()};
    leg.force = number();
    leg.lag = number();
    leg.phase = 2;
    leg.q = leg_joints({number(), number(), number()});
  }
  return f;
}

// A multiple of 0.375 below 2²¹ is exact in a float; only the rotation is rounded, to steps of 2⁻¹⁶.
TEST(PoseFrame, ComesBackAsItWas) {
  const PoseFrame f = numbered(), g = decode(encode(f, LegArray<int>(kLegs, 3)));
  EXPECT_EQ(g.flags, f.flags);
  EXPECT_EQ(g.fault, f.fault);
  EXPECT_EQ(g.scene, f.scene);
  EXPECT_EQ(g.tick, f.tick);
  EXPECT_EQ(g.holder, f.holder);
  EXPECT_EQ(g.time, f.time);
  EXPECT_EQ(g.speed_factor, f.speed_factor);
  EXPECT_EQ(g.X_WB.p, f.X_WB.p);
  EXPECT_TRUE(g.X_WB.R.isApprox(f.X_WB.R, 5e-5));
  EXPECT_EQ(g.velocity.v, f.velocity.v);
  EXPECT_EQ(g.velocity.w, f.velocity.w);
  EXPECT_EQ(g.rho, f.rho);
  EXPECT_EQ(g.k, f.k);
  EXPECT_EQ(g.crab, f.crab);
  EXPECT_TRUE(g.moving);
  EXPECT_EQ(g.centre, f.centre);
  EXPECT_EQ(g.margin, f.margin);
  EXPECT_EQ(g.com, f.com);
  EXPECT_EQ(g.lateral, f.lateral);
  EXPECT_EQ(g.path, f.path);
  EXPECT_EQ(g.slip_speed, f.slip_speed);
  EXPECT_EQ(g.power, f.power);
  EXPECT_EQ(g.raw, f.raw);
  EXPECT_EQ(g.state, f.state);
  EXPECT_EQ(g.ccn, f.ccn);
  EXPECT_EQ(g.type, f.type);
  EXPECT_EQ(g.priority, f.priority);
  EXPECT_EQ(g.may_step, f.may_step);
  EXPECT_EQ(g.waits, f.waits);
  EXPECT_EQ(g.contact, f.contact);
  EXPECT_EQ(g.support, f.support);
  EXPECT_EQ(g.urgent, f.urgent);
  ASSERT_EQ(g.polygon.size, f.polygon.size);
  EXPECT_EQ(g.polygon.vertices[1], f.polygon.vertices[1]);
  ASSERT_EQ(g.legs.size(), kLegs);
  for (LegId i = 0; i < kLegs; ++i) {
    EXPECT_EQ(g.legs[i].p_WF, f.legs[i].p_WF);
    EXPECT_EQ(g.legs[i].p_WT, f.legs[i].p_WT);
    EXPECT_EQ(g.legs[i].force, f.legs[i].force);
    EXPECT_EQ(g.legs[i].lag, f.legs[i].lag);
    EXPECT_EQ(g.legs[i].phase, f.legs[i].phase);
    EXPECT_EQ(g.legs[i].q, f.legs[i].q);
  }
}

// By the layout in the header: 4 × 1 + 3 × 4 + 8 + 4 + 28 + 12 + 16 + 8 + 16 + 16 bytes of motion, 4
// + 2 + 12 + 1 + 8 per corner of gait, and 34 + 4 per joint of each leg.
TEST(PoseFrame, HasTheLengthThatItsLayoutSays) {
  const std::size_t motion = 4 + 12 + 8 + 4 + 28 + 12 + 16 + 8 + 16 + 16, gait = 4 + 2 + 12 + 1;
  EXPECT_EQ(encode(numbered(), LegArray<int>(kLegs, 3)).size(),
            motion + gait + 2 * 8 + kLegs * (34 + 3 * 4));
}

// encode() and decode() share one order; a page has its own. By the layout in the header.
TEST(PoseFrame, HasItsNumbersWhereItsLayoutSays) {
  const PoseFrame f = numbered();
  const std::string bytes = encode(f, LegArray<int>(kLegs, 3));
  const auto f32 = [&](std::size_t at) {
    float value = 0.0F;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return static_cast<double>(value);
  };
  const auto u8 = [&](std::size_t at) { return static_cast<unsigned char>(bytes[at]); };
  EXPECT_EQ(u8(2), f.flags);
  EXPECT_EQ(u8(3), f.fault);
  EXPECT_EQ(u8(4), f.scene);
  EXPECT_EQ(u8(12), f.holder);
  const double numbers[] = {f.speed_factor, f.X_WB.p.x(), f.X_WB.p.y(), f.X_WB.p.z()};
  for (std::size_t k = 0; k < std::size(numbers); ++k) EXPECT_EQ(f32(24 + 4 * k), numbers[k]);
  const double w = f32(52);  // of the quaternion, last: |rotation vector|² = 0.94
  EXPECT_NEAR(2.0 * std::acos(w), std::sqrt(0.94), 1e-4);
  const double more[] = {
      f.velocity.v.x(), f.velocity.v.y(), f.velocity.w, f.rho,     f.k,       f.crab,    1.0,
      f.centre.x(),     f.centre.y(),     f.margin,     f.com.x(), f.com.y(), f.com.z(), f.lateral,
      f.path,           f.slip_speed,     f.power};
  for (std::size_t k = 0; k < std::size(more); ++k) EXPECT_EQ(f32(56 + 4 * k), more[k]) << k;
  const int gait[] = {0x01, 0x01, 0xA5, 0, f.ccn, f.type, 1, 0, 2, 0, 4, 0, 8, 0, 9, 0, 12, 0};
  for (std::size_t k = 0; k < std::size(gait); ++k) EXPECT_EQ(u8(124 + k), gait[k]) << k;
  const std::size_t leg = 142 + (34 + 3 * 4);  // the second one
  EXPECT_EQ(f32(leg), f.legs[1].p_WF.x());
  EXPECT_EQ(f32(leg + 12), f.legs[1].p_WT.x());
  EXPECT_EQ(f32(leg + 24), f.legs[1].force);
  EXPECT_EQ(f32(leg + 28), f.legs[1].lag);
  EXPECT_EQ(u8(leg + 32), f.legs[1].phase);
  EXPECT_EQ(u8(leg + 33), 3);
  EXPECT_EQ(f32(leg + 34), f.legs[1].q[0]);
  const std::size_t polygon = 142 + kLegs * (34 + 3 * 4);
  EXPECT_EQ(u8(polygon), 2);
  EXPECT_EQ(f32(polygon + 1), f.polygon.vertices[0].x());
}

TEST(PoseFrame, ThatIsCutOffOrTooLongIsRefused) {
  const std::string bytes = encode(numbered(), LegArray<int>(kLegs, 3));
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW((void)decode(std::string_view(bytes).substr(0, size)), InvalidInput);
  EXPECT_THROW((void)decode(bytes + "x"), InvalidInput);
  std::string other_version = bytes;
  other_version[0] = 7;
  EXPECT_THROW((void)decode(other_version), InvalidInput);
}

}  // namespace
}  // namespace hexagait::viewer
