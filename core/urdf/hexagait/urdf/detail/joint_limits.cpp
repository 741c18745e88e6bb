// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/params/params_for.hpp>
#include <hexagait/urdf/detail/feet.hpp>
#include <hexagait/urdf/detail/joint_limits.hpp>
#include <numbers>

namespace hexagait {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kNoLimit = 1000.0;      // [rad]
constexpr double kMostTurn = 4.0 * kPi;  // of a limit that is meant in radians
constexpr double kAbsurd = 20.0, kUsualSpeed = 1.5, kUsualEffort = 0.5;  // of √(g/l), m g l

/// A value of a joint's drive, if the file's can't be.
double settled(double found, double absurd, double usual, const std::optional<double>& given,
               Substitution substitution, const char* unit, bool is_missing,
               std::vector<Substitution>& substitutions) {
  if (found > 0.0 && found <= absurd) return found;
  const double used = given.value_or(usual);
  substitution.found = is_missing ? "none" : in_words(found) + " " + unit;
  substitution.used = in_words(used) + " " + unit;
  if (given) substitution.origin = Origin::given;
  substitutions.push_back(std::move(substitution));
  return used;
}

}  // namespace

JointRange range_of(const FileJoint& joint, bool first, const UrdfOptions& options) {
  if (joint.type == FileJoint::Type::continuous) return {-kPi, kPi, "", ""};
  const bool missing = !joint.lower && !joint.upper;
  const double lower = joint.lower.value_or(0.0), upper = joint.upper.value_or(0.0);
  if (missing || (lower == 0.0 && upper == 0.0)) {
    const double range = options.joint_range.value_or(first ? kPi / 2.0 : 5.0 * kPi / 6.0);
    return {-range, range, missing ? "none" : "0 to 0 rad", ""};
  }
  const std::string found = in_words(lower) + " to " + in_words(upper) + " rad";
  if (lower <= -kNoLimit && upper >= kNoLimit) return {-kPi, kPi, found, ""};
  if (!(lower < upper))
    return {-kPi, kPi, "",
            "lower limit " + in_words(lower) + " rad, upper limit " + in_words(upper) +
                " rad; need lower < upper"};
  if (std::abs(lower) > kMostTurn || std::abs(upper) > kMostTurn)
    return {-kPi, kPi, "",
            "limits " + found + " are more than two turns; a URDF has radians, these are degrees?"};
  return {lower, upper, "", ""};
}

void settle_drives(const UrdfFile& file, const UrdfOptions& options, RobotTree& tree,
                   std::vector<Substitution>& substitutions) {
  double mass = tree.base.mass;
  for (const SerialChain& chain : tree.chains)
    for (const LinkModel& link : chain.links) mass += link.mass;
  for (SerialChain& chain : tree.chains) {
    const double length = length_of(chain, chain.foot->p_BF0);
    const double speed = std::sqrt(kStandardGravity / length),
                 effort = mass * kStandardGravity * length;
    for (TreeJoint& joint : chain.joints) {
      const FileJoint& in_file = file.joint(joint.index);
      JointLimits& limits = joint.limits;
      Substitution about{Origin::substituted, "joint " + joint.name, in_file.line, "", "", "", ""};
      about.what = "velocity limit", about.option = "--joint-speed";
      limits.velocity =
          settled(limits.velocity, kAbsurd * speed, kUsualSpeed * speed, options.joint_speed, about,
                  "rad/s", !in_file.velocity, substitutions);
      about.what = "effort limit", about.option = "--joint-effort";
      limits.effort = settled(limits.effort, kAbsurd * effort, kUsualEffort * effort,
                              options.joint_effort, about, "N m", !in_file.effort, substitutions);
    }
  }
}

}  // namespace hexagait
