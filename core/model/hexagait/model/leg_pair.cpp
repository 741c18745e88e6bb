// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/math/lane_sincos.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/leg_pair.hpp>
#include <hexagait/model/yaw_and_pitches.hpp>

namespace hexagait {
namespace {

using detail::twice_atan;

// Rᵀ v, in the order in which Eigen adds.
LaneVector turned_back(const LegPair& pair, const LaneVector& v) {
  const auto row = [&](int k) {
    const Lanes x = pair.of([k](const LegModel& leg) { return leg.X_BH.R(0, k); });
    const Lanes y = pair.of([k](const LegModel& leg) { return leg.X_BH.R(1, k); });
    const Lanes z = pair.of([k](const LegModel& leg) { return leg.X_BH.R(2, k); });
    return x * v.x + y * v.y + z * v.z;
  };
  return {row(0), row(1), row(2)};
}

Lanes clamped(Lanes x, Lanes lowest, Lanes highest) {
  const Lanes raised = x < lowest ? lowest : x;
  return highest < raised ? highest : raised;
}

// Of half the angle from (c0, s0) to (c1, s1).
Lanes tan_of_half(Lanes c0, Lanes s0, Lanes c1, Lanes s1) {
  return (s1 * c0 - c1 * s0) / (1.0 + (c1 * c0 + s1 * s0));
}

}  // namespace

LegPair::Angles LegPair::trig(const LegJoints& q_a, const LegJoints& q_b) const noexcept {
  const LaneVector q = three_lanes(q_a, q_b);
  const auto canonical = [&](int k, Lanes q) {
    const Lanes sign = of([k](const LegModel& leg) { return leg.joint_sign[k]; });
    const Lanes offset = of([k](const LegModel& leg) { return leg.joint_offset[k]; });
    return sign * q + offset;
  };
  const Lanes k1 = canonical(0, q.x), k2 = canonical(1, q.y), k23 = k2 + canonical(2, q.z);
  const auto yaw = portable::sincos(k1), hip = portable::sincos(k2), tibia = portable::sincos(k23);
  return {q, LaneVector{yaw.c, hip.c, tibia.c}, LaneVector{yaw.s, hip.s, tibia.s}};
}

bool LegPair::go_on(const LaneVector& p_BF, const Angles& near, Angles& to) const noexcept {
  const LaneVector p_BH = lanes(a_.X_BH.p, b_.X_BH.p);
  const LaneVector p_HF = turned_back(*this, {p_BF.x - p_BH.x, p_BF.y - p_BH.y, p_BF.z - p_BH.z});
  const Lanes r = root(p_HF.x * p_HF.x + p_HF.y * p_HF.y);
  const Lanes a = r - of([](const LegModel&leg) { return leg.coxa; }), b = -p_HF.z;
  const Lanes d2 = a * a + b * b;
  const Lanes least = of([](const LegModel& leg) { return leg.min_reach; });
  const Lanes most = of([](const LegModel& leg) { return leg.max_reach; });
  auto usual = (r >= YawPitchPitchLeg::kOnAxis) & (d2 >= least * least) & (d2 <= most * most);

  const Lanes f = of([](const LegModel& leg) { return leg.femur; });
  const Lanes t = of([](const LegModel& leg) { return leg.tibia; });
  const Lanes c3 = clamped((d2 - f * f - t * t) / (2.0 * f * t), both(-1.0), both(1.0));
  const Lanes s3 = root(1.0 - c3 * c3);
  const Lanes A = f + t * c3, B = t * s3;
  const Lanes c2 = (A * a + B * b) / d2, s2 = (A * b - B * a) / d2;
  to.c = {p_HF.x / r, c2, c2 * c3 - s2 * s3};
  to.s = {p_HF.y / r, s2, s2 * c3 + c2 * s3};

  const Lanes u1 = tan_of_half(near.c.x, near.s.x, to.c.x, to.s.x);
  const Lanes u2 = tan_of_half(near.c.y, near.s.y, to.c.y, to.s.y);
  const Lanes u3 = tan_of_half(near.c.z, near.s.z, to.c.z, to.s.z);
  constexpr double kLittle = YawPitchPitchLeg::kLittle;
  usual &= (magnitude(u1) <= kLittle) & (magnitude(u2) <= kLittle) & (magnitude(u3) <= kLittle);
  const Lanes turn1 = twice_atan(u1), turn2 = twice_atan(u2), turn3 = twice_atan(u3) - turn2;
  const auto goes_to = [&](int k, Lanes from, Lanes turn) {
    const Lanes q = from + of([k](const LegModel& leg) { return leg.joint_sign[k]; }) * turn;
    usual &= (of([k](const LegModel& leg) { return leg.limits[k].lower; }) <= q) &
             (q <= of([k](const LegModel& leg) { return leg.limits[k].upper; }));
    return q;
  };
  to.q = {goes_to(0, near.q.x, turn1), goes_to(1, near.q.y, turn2), goes_to(2, near.q.z, turn3)};
  return all(usual);
}

void forward_kinematics(const RobotModel& model, const LegArray<LegJoints>& q,
                        LegArray<LegTrig>& trig, LegArray<Vector3>& p_BF) noexcept {
  const auto closed = [&](LegId i) { return model.legs[i].kind == LegKind::yaw_pitch_pitch; };
  LegId i = 0;
  for (; i + 1 < model.num_legs() && closed(i) && closed(i + 1); i += 2) {
    const LegPair::Angles both = LegPair(model.legs[i], model.legs[i + 1]).trig(q[i], q[i + 1]);
    const auto take = [&](LegId leg, int lane) {
      put(both.c, lane, trig[leg].c);
      put(both.s, lane, trig[leg].s);
      p_BF[leg] = YawPitchPitchLeg::foot_position(model.legs[leg], trig[leg]);
    };
    take(i, 0);
    take(i + 1, 1);
  }
  for (; i < model.num_legs(); ++i) {
    trig[i] = leg_trig(model.legs[i], q[i]);
    p_BF[i] = foot_position(model.legs[i], trig[i]);
  }
}

}  // namespace hexagait
