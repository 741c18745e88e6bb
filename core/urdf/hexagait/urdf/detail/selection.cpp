// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/math/leg.hpp>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/urdf/detail/rounded.hpp>
#include <hexagait/urdf/detail/selection.hpp>
#include <hexagait/urdf/detail/symmetry.hpp>

namespace hexagait {
namespace {

constexpr double kDeepEnough = 0.3;                // of the middle leg's way below the underside
constexpr double kShortest = 0.6, kLongest = 1.6;  // of the middle leg's length
constexpr int kUsualJoints = 3;                    // of a leg; those of two joints are rare
constexpr double kOnAxis = 0.1;                    // of a wheel's radius
// Beyond these it is no robot of ours in any case, and searches would take long.
constexpr int kMostJoints = 2 * kMaxLegJoints;
constexpr std::size_t kMostLegs = 2 * kMaxLegs;

/// A candidate, measured.
struct Measured {
  int joints = 0;
  double length = 0.0, lowest = 0.0;  ///< [m]
  double wheel = 0.0;    ///< radius of the wheel that is its last link; 0: it is none [m]
  bool reaches = false;  ///< it gets down as a leg does
};

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Where p is when all joints have turned by q.
Vector3 turned(const SerialChain& chain, const std::vector<double>& q, Vector3 p) {
  for (std::size_t i = q.size(); i-- > 0;) {
    const TreeJoint& joint = chain.joints[i];
    p = rotation_about(joint.p_BJ0, rotation(joint.axis_B0 * q[i])) * p;
  }
  return p;
}

/// The least height by one joint after the other: as a function of one joint the height is
/// a + b cos q + c sin q.
double descend(const SerialChain& chain, const Vector3& p_BF0, std::vector<double> q) {
  constexpr int kRounds = 10;
  const auto height = [&] { return turned(chain, q, p_BF0).z(); };
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t i = 0; i < q.size(); ++i) {
      const auto at = [&](double angle) { return q[i] = angle, height(); };
      const double zero = at(0.0), quarter = at(0.5 * std::numbers::pi),
                   half = at(std::numbers::pi);
      const double a = 0.5 * (zero + half), b = zero - a, c = quarter - a;
      const JointLimits& limits = chain.joints[i].limits;
      const double middle = 0.5 * (limits.lower + limits.upper);
      double lowest = middle + wrap_angle(portable::atan2(-c, -b) - middle);
      if (lowest < limits.lower || lowest > limits.upper)
        lowest = at(limits.lower) < at(limits.upper) ? limits.lower : limits.upper;
      q[i] = lowest;
    }
  return height();
}

/// Radius of the wheel that the last link is: a round shape about the axis of its joint.
double wheel_radius(const SerialChain& chain) {
  const LinkModel& tip = chain.links.back();
  const Vector3 axis_L = tip.X_BL0.R.transpose() * chain.joints.back().axis_B0;
  const LinkParts& parts = chain.parts.back();
  for (const LinkParts::Solid& solid :
       parts.collisions.empty() ? parts.visuals : parts.collisions) {
    const FileShape& shape = *solid.shape;
    const bool along = solid.X_LS.R.col(2).cross(axis_L).norm() < 0.1;
    const bool is_round =
        shape.kind == FileShape::Kind::sphere || (shape.kind == FileShape::Kind::cylinder && along);
    const double off_axis = solid.X_LS.p.cross(axis_L).norm();
    if (is_round && off_axis < kOnAxis * shape.size.x()) return shape.size.x();
  }
  return 0.0;
}

/// The lowest point of the body's shapes; where it has none, of the hips.
double underside(const RobotTree& tree) {
  double lowest = 1e300;
  for (const Shape& shape : tree.base.shapes) {
    const Vector3 down = shape.X_LS.R.transpose().col(2);
    double depth = shape.size.x();
    if (shape.kind == Shape::Kind::box) depth = 0.5 * shape.size.dot(down.cwiseAbs());
    if (shape.kind == Shape::Kind::cylinder)
      depth = shape.size.x() * portable::hypot(down.x(), down.y()) +
              0.5 * shape.size.y() * std::abs(down.z());
    lowest = std::min(lowest, shape.X_LS.p.z() - depth);
  }
  if (tree.base.shapes.empty())
    for (const SerialChain& chain : tree.chains)
      lowest = std::min(lowest, chain.joints.front().p_BJ0.z());
  return lowest;
}

std::vector<Measured> measure(const RobotTree& tree,
                              const std::vector<std::optional<FoundFoot>>& feet, double bottom) {
  std::vector<Measured> all;
  std::vector<double> depths;
  for (std::size_t i = 0; i < tree.chains.size(); ++i) {
    const SerialChain& chain = tree.chains[i];
    const Vector3 tip = chain.links.back().X_BL0 * (feet[i] ? feet[i]->p_LF : Vector3::Zero());
    Measured m{static_cast<int>(chain.joints.size()), length_of(chain, tip), 0.0,
               wheel_radius(chain)};
    m.lowest = m.joints <= kMostJoints ? lowest_reach(chain, tip) : bottom;
    if (m.joints >= 2 && m.lowest < bottom) depths.push_back(bottom - m.lowest);
    all.push_back(m);
  }
  const double depth = median(depths);
  for (Measured& m : all)
    m.reaches = m.joints >= 2 && bottom - m.lowest > kDeepEnough * depth && m.lowest < bottom;
  return all;
}

bool is_as_long(const Measured& m, double length) {
  return kShortest * length < m.length && m.length < kLongest * length;
}

std::string in_joints(int joints) {
  return "has " + std::to_string(joints) + " movable joints; a leg has " +
         std::to_string(kMinLegJoints) + " to " + std::to_string(kMaxLegJoints);
}

/// The length of the middle leg: of those with three joints or more, if there are some.
/// @param fewest  joints of a leg of this robot
double usual_length(const std::vector<Measured>& all, int& fewest) {
  for (fewest = kUsualJoints; fewest >= kMinLegJoints; --fewest) {
    std::vector<double> lengths;
    for (const Measured& m : all)
      if (m.reaches && m.joints >= fewest) lengths.push_back(m.length);
    if (lengths.size() >= 4 || (fewest == kMinLegJoints && !lengths.empty()))
      return median(lengths);
  }
  return 0.0;
}

Verdict verdict(const Measured& m, double bottom, double length, int fewest) {
  const bool as_long = is_as_long(m, length);
  if (m.joints < 2)
    return {m.joints == 0   ? "has no joint that turns"
            : m.wheel > 0.0 ? "is a wheel of radius " + metres(m.wheel) + ", and a leg has " +
                                  std::to_string(kMinLegJoints) + " joints or more"
                            : "turns about one axis only, and a leg has " +
                                  std::to_string(kMinLegJoints) + " joints or more",
            ""};
  if (m.joints > kMostJoints) return {in_joints(m.joints), ""};
  if (!m.reaches) {
    const std::string why = "gets down to z = " + metres(m.lowest) +
                            " only; the body's underside is at " + metres(bottom);
    return as_long && m.joints >= fewest
               ? Verdict{"", why + "; its joint limits must let it reach the ground"}
               : Verdict{why, ""};
  }
  if (m.joints < fewest) {
    const std::string few =
        "has " + std::to_string(m.joints) + " movable joints, and the other legs have more";
    return as_long ? Verdict{"", few + ": give it as many"} : Verdict{few, ""};
  }
  if (m.joints > kMaxLegJoints) return {"", in_joints(m.joints)};
  if (m.wheel > 0.0 && m.wheel > 0.05 * m.length)
    return {"", "ends in a wheel of radius " + metres(m.wheel) +
                    "; hexagait walks on feet: make its joint fixed"};
  return {};
}

/// What has no mirror partner and is not like the others is no leg.
void leave_out_the_odd(const RobotTree& tree, const std::vector<Measured>& all, double length,
                       const UrdfOptions& options, std::vector<Verdict>& verdicts) {
  std::vector<std::size_t> legs;
  std::vector<Vector2> hips;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (!verdicts[i].why_not.empty()) continue;
    legs.push_back(i);
    hips.emplace_back(tree.chains[i].joints.front().p_BJ0.head<2>());
  }
  if (legs.size() > kMostLegs) return;
  const Symmetry symmetry =
      options.front ? symmetry_along(hips, *options.front) : find_symmetry(hips);
  if (symmetry.num_paired() < 4) return;
  for (std::size_t k = 0; k < legs.size(); ++k) {
    const Measured& m = all[legs[k]];
    if (symmetry.partner[k] >= 0 || is_as_long(m, length)) continue;
    verdicts[legs[k]].why_not = "has no mirror partner, and is " + metres(m.length) +
                                " long where legs are " + metres(length);
  }
}

std::vector<Verdict> as_given(const UrdfFile& file, const RobotTree& tree,
                              const std::vector<std::string>& legs) {
  std::vector<Verdict> verdicts;
  for (const SerialChain& chain : tree.chains) {
    const std::string& first = file.joint(chain.joints[0].index).name;
    const bool is_leg = std::ranges::find(legs, first) != legs.end();
    verdicts.push_back({is_leg ? "" : "is not among those of --legs", ""});
    const int joints = static_cast<int>(chain.joints.size());
    if (is_leg && (joints < kMinLegJoints || joints > kMaxLegJoints))
      verdicts.back().problem = in_joints(joints);
  }
  return verdicts;
}

}  // namespace

double lowest_reach(const SerialChain& chain, const Vector3& p_BF0) {
  double lowest = 1e300;
  for (const double share : {0.1, 0.5, 0.9}) {
    std::vector<double> q;
    for (const TreeJoint& joint : chain.joints)
      q.push_back(joint.limits.lower + share * (joint.limits.upper - joint.limits.lower));
    lowest = std::min(lowest, descend(chain, p_BF0, q));
  }
  return lowest;
}

std::vector<Verdict> judge(const UrdfFile& file, const RobotTree& tree,
                           const std::vector<std::optional<FoundFoot>>& feet,
                           const UrdfOptions& options) {
  if (!options.legs.empty()) return as_given(file, tree, options.legs);
  const double bottom = underside(tree);
  const std::vector<Measured> all = measure(tree, feet, bottom);
  int fewest = kUsualJoints;
  const double length = usual_length(all, fewest);
  std::vector<Verdict> verdicts;
  verdicts.reserve(all.size());
  for (const Measured& m : all) verdicts.push_back(verdict(m, bottom, length, fewest));
  leave_out_the_odd(tree, all, length, options, verdicts);
  return verdicts;
}

}  // namespace hexagait
