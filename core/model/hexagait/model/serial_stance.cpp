// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/serial_stance.hpp>
#include <limits>

namespace hexagait {
namespace {

// Nominal height / longest reach, first axis horizontal: the leg has as much to give downwards, where
// the ground is lower, as it needs upwards.
constexpr double kUprightHeight = 0.66;
constexpr double kSteep = 0.7;         // a first axis with a greater z is a yaw axis
constexpr double kImmobile = 1e-3;     // dexterity below which the foot cannot move in a direction
constexpr double kNimble = 0.08;       // dexterity that suffices for a nominal stance
constexpr double kFarFromLimit = 0.3;  // more clearance from a joint limit is no better [rad]
constexpr double kSameScore = 1e-6;
constexpr double kIntersecting = 1e-6;  // axes nearer to each other intersect [m]
constexpr double kUnchanged = 1e-9;     // of a squared distance [m²]

bool has_steep_first_axis(const LegModel& leg) { return std::abs(leg.axis_B0[0].z()) >= kSteep; }

/// Smallest singular value of the Jacobian over the reach; 0 where the foot cannot move in some
/// direction.
double dexterity(const LegModel& leg, const LegJoints& q) {
  const LegJacobian J = foot_jacobian(leg, leg_trig(leg, q));
  const Matrix3 JJ = J * J.transpose();
  const double least =
      Eigen::SelfAdjointEigenSolver<Matrix3>(JJ, Eigen::EigenvaluesOnly).eigenvalues().minCoeff();
  return std::sqrt(std::max(least, 0.0)) / leg.max_reach;
}

/// A grid of postures: `levels` values of each joint from `first` on.
std::vector<LegJoints> postures(const LegModel& leg, int levels, int first = 0) {
  std::vector<LegJoints> all = {LegJoints::Zero()};
  for (int i = first; i < leg.num_joints(); ++i) {
    std::vector<LegJoints> more;
    const JointLimits& limits = leg.limits[i];
    for (LegJoints q : all)
      for (int level = 0; level < levels; ++level) {
        q[i] = limits.lower + (limits.upper - limits.lower) * (level + 0.5) / levels;
        more.push_back(q);
      }
    all = std::move(more);
  }
  return all;
}

/// The angle within `limits` that maximises sign · (b cos q + c sin q), modulo 2π nearest to the
/// middle of the limits; a limit if the maximum lies outside.
double best_angle(const JointLimits& limits, double b, double c, double sign) {
  const double middle = 0.5 * (limits.lower + limits.upper);
  const double top = middle + wrap_angle(portable::atan2(sign * c, sign * b) - middle);
  if (limits.lower <= top && top <= limits.upper) return top;
  const auto value = [&](double q) { return sign * Vector2(b, c).dot(unit_vector(q)); };
  return value(limits.lower) > value(limits.upper) ? limits.lower : limits.upper;
}

/// Largest (sign 1) or smallest (sign −1) distance of the foot from the hip, by coordinate descent
/// from q [m].
double extreme_distance(const LegModel& leg, LegJoints q, double sign) {
  constexpr int kMaxRounds = 30;
  const auto squared = [&] { return (foot_position(leg, q) - leg.X_BH.p).squaredNorm(); };
  double last = squared();
  for (int round = 0; round < kMaxRounds; ++round) {
    for (int i = 1; i < leg.num_joints(); ++i) {
      // Three samples determine the sinusoid.
      const auto at = [&](double angle) { return q[i] = angle, squared(); };
      const double zero = at(0.0), quarter = at(0.5 * std::numbers::pi),
                   half = at(std::numbers::pi);
      const double a = 0.5 * (zero + half);
      q[i] = best_angle(leg.limits[i], zero - a, quarter - a, sign);
    }
    const double now = squared();
    const bool settled = std::abs(now - last) < kUnchanged;
    last = now;
    if (settled) break;
  }
  return std::sqrt(last);
}

Reach extreme_distances(const LegModel& leg) {
  // The hip is on the first axis, so joint 0 has no effect. Starts from the most promising
  // postures.
  constexpr std::size_t kStarts = 6;
  std::vector<LegJoints> starts = postures(leg, 2, 1);
  const std::size_t n = std::min(kStarts, starts.size());
  std::ranges::sort(starts, {}, [&](const LegJoints& q) {
    return (foot_position(leg, q) - leg.X_BH.p).squaredNorm();
  });
  Reach reach{std::numeric_limits<double>::infinity(), 0.0};
  for (std::size_t i = 0; i < n; ++i) {
    reach.min = std::min(reach.min, extreme_distance(leg, starts[i], -1.0));
    reach.max = std::max(reach.max, extreme_distance(leg, starts[starts.size() - 1 - i], 1.0));
  }
  return reach;
}

/// Quality of a posture: dexterity and clearance, some preference for knees up; knees inwards
/// decide between equals.
struct Score {
  double value = -1.0;
  double inwards = 0.0;

  friend bool operator<(const Score& a, const Score& b) {
    if (std::abs(a.value - b.value) > kSameScore) return a.value < b.value;
    return a.inwards < b.inwards - kSameScore;
  }
};

Score score(const LegModel& leg, const LegJoints& q) {
  double clearance = kFarFromLimit, up = 0.0, inwards = 0.0;
  for (int i = 0; i < leg.num_joints(); ++i) {
    clearance = std::min({clearance, q[i] - leg.limits[i].lower, leg.limits[i].upper - q[i]});
    const Vector3 p = link_pose(leg, i, q).p;
    up += p.z() - leg.X_BH.p.z();
    inwards -= p.head<2>().norm();
  }
  const double height = up / (leg.num_joints() * leg.max_reach);
  return {dexterity(leg, q) * (clearance / kFarFromLimit) * (1.0 + height), inwards};
}

/// The best posture with the foot at p_BF. A leg of more than three joints has a continuum of them,
/// which is sampled by giving each search its own q_nominal.
Score best_posture(const LegModel& leg, const Vector3& p_BF, LegJoints& best_q) {
  const int n = leg.num_joints(), levels = n == 3 ? 4 : n == 4 ? 3 : 2;
  Score best;
  LegModel model = leg;
  for (const LegJoints& from : postures(leg, levels)) {
    model.q_nominal = from;
    const LegSolution solution = inverse_kinematics(model, p_BF);
    if (!solution.reachable) continue;
    const Score found = score(leg, solution.q);
    if (best < found) best = found, best_q = solution.q;
  }
  return best;
}

/// Does this joint lift the foot, rather than twist or turn the leg?
bool bends(const LegModel& leg, int joint) {
  return has_steep_first_axis(leg) ? std::abs(leg.axis_B0[joint].dot(leg.X_BH.R.col(1))) > kSteep
                                   : joint > 0;
}

/// The first joint after the coxa: the first one that bends; the second one if none does.
int first_bend(const LegModel& leg) {
  for (int i = 1; i < leg.num_joints(); ++i)
    if (bends(leg, i)) return i;
  return 1;
}

/// The rule's place for the nominal foot, in the hip frame [m].
Vector3 nominal_place(const LegModel& leg) {
  const SerialLengths lengths = serial_lengths(leg);
  if (!has_steep_first_axis(leg)) return {lengths.lateral, 0.0, -kUprightHeight * leg.max_reach};
  return {lengths.coxa + lengths.upper, 0.0, -(lengths.upper + lengths.rest) / kHeightRatio};
}

/// That place and others around it, the nearest first.
std::vector<Vector3> places(const LegModel& leg) {
  constexpr int kRings = 2;
  constexpr double kStep = 0.15;  // of the longest reach
  const Vector3 rule = nominal_place(leg);
  std::vector<Vector3> all = {rule};
  for (int x = -kRings; x <= kRings; ++x)
    for (int z = -kRings; z <= kRings; ++z)
      if (x != 0 || z != 0) all.push_back(rule + kStep * leg.max_reach * Vector3(x, 0, z));
  std::ranges::stable_sort(all, {}, [&](const Vector3& p) { return (p - rule).norm(); });
  return all;
}

/// Is there no posture in which the foot can move in all three directions?
bool is_immobile(const LegModel& leg) {
  return std::ranges::all_of(postures(leg, 3),
                             [&](const LegJoints& q) { return dexterity(leg, q) < kImmobile; });
}

}  // namespace

SerialLengths serial_lengths(const LegModel& leg) {
  SerialLengths lengths;
  const int n = leg.num_joints(), bend = first_bend(leg);
  Vector3 entry = leg.p_BJ0[0];  // where the way along the leg meets the axis
  for (int i = 0; i < n; ++i) {
    const bool last = i + 1 == n;
    const Vector3 p = leg.p_BJ0[i], a = leg.axis_B0[i];
    const NearestPoints ends = last ? nearest_points(p, a, leg.p_BF0, a)
                                    : nearest_points(p, a, leg.p_BJ0[i + 1], leg.axis_B0[i + 1]);
    double length = (ends.on_second - ends.on_first).norm();
    // Along its own axis only a joint that twists the leg lengthens it.
    if (i > 0 && !bends(leg, i)) length += (ends.on_first - entry).norm();
    entry = ends.on_second;
    const bool in_upper = i >= bend && lengths.upper < kIntersecting;
    (i < bend ? lengths.coxa : in_upper ? lengths.upper : lengths.rest) += length;
  }
  lengths.lateral = leg.X_BH.R.col(0).dot(leg.p_BF0 - leg.X_BH.p);
  return lengths;
}

Reach serial_reach(const LegModel& leg) {
  LegModel unlimited = leg;
  for (JointLimits& limits : unlimited.limits) limits = JointLimits{};
  const Reach free = extreme_distances(unlimited), limited = extreme_distances(leg);
  const double margin = kSingularMargin * free.max;
  return {.min = std::max(limited.min, free.min + margin),
          .max = std::min(limited.max, free.max - margin)};
}

void take_serial_stance(LegModel& leg, Violations& violations) {
  const Reach reach = serial_reach(leg);
  leg.min_reach = reach.min;
  leg.max_reach = std::max(reach.max, reach.min);
  if (!(reach.max > 0.0) || is_immobile(leg)) {
    violations.add("leg " + leg.name,
                   "its joints cannot move the foot in all three directions; they must");
    return;
  }

  // The first place that is good enough, otherwise the best one.
  Score best;
  for (const Vector3& p_HF : places(leg)) {
    const Vector3 p_BF = leg.X_BH * p_HF;
    LegJoints q;
    const Score found = best_posture(leg, p_BF, q);
    if (best < found) best = found, leg.p_BC = p_BF, leg.q_nominal = q;
    if (best.value > kNimble) break;
  }
  if (!(best.value > kImmobile)) {
    violations.add("leg " + leg.name,
                   "has no stance outside and below its hip at which the foot can be moved in all "
                   "three directions; the joint limits must allow one");
    return;
  }
  leg.workspace_radius = reachable_radius(leg);
}

}  // namespace hexagait
