// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/leg_weight.hpp>
#include <hexagait/model/serial_stance.hpp>
#include <hexagait/model/workspace.hpp>
#include <hexagait/text/text_file.hpp>
#include <hexagait/urdf/detail/leg_recognition.hpp>
#include <hexagait/urdf/detail/robot_tree.hpp>
#include <hexagait/urdf/detail/xml_size.hpp>
#include <hexagait/urdf/urdf.hpp>

namespace hexagait {
namespace {

constexpr double kSameRadius = 1e-6;  // [m]
constexpr double kOnMidline = 1e-4;   // [m]

/// All feet must be alike.
double foot_radius(const RobotTree& tree, Violations& violations) {
  const SerialChain *smallest = nullptr, *largest = nullptr;
  for (const SerialChain& chain : tree.chains) {
    if (!chain.foot) continue;
    if (!smallest || chain.foot->radius < smallest->foot->radius) smallest = &chain;
    if (!largest || chain.foot->radius > largest->foot->radius) largest = &chain;
  }
  if (!smallest) return 0.0;
  const double difference = largest->foot->radius - smallest->foot->radius;
  if (difference > kSameRadius)
    violations.add("robot", "foot radii range from " + in_words(smallest->foot->radius) + " m (" +
                                smallest->links.back().name + ") to " +
                                in_words(largest->foot->radius) + " m (" +
                                largest->links.back().name + "); all feet must be alike");
  return smallest->foot->radius;
}

/// Left and right legs in turn, pairs from front to rear, by where the hips are.
LegArray<LegModel> in_leg_order(std::vector<LegModel> legs, Violations& violations) {
  for (const LegModel& leg : legs)
    if (std::abs(leg.X_BH.p.y()) < kOnMidline)
      violations.add("leg " + leg.name, "hip is at y = " + in_words(leg.X_BH.p.y()) +
                                            " m; it must be left or right of the middle");
  std::stable_sort(legs.begin(), legs.end(), [](const LegModel& a, const LegModel& b) {
    return a.X_BH.p.x() > b.X_BH.p.x();
  });
  const auto right = std::stable_partition(
      legs.begin(), legs.end(), [](const LegModel& leg) { return leg.X_BH.p.y() > 0.0; });
  const auto num_left = right - legs.begin(), num_right = legs.end() - right;
  if (num_left != num_right) {
    violations.add("robot", "has " + std::to_string(num_left) + " legs on the left and " +
                                std::to_string(num_right) + " on the right; need as many");
    return {};
  }
  LegArray<LegModel> ordered(static_cast<int>(legs.size()));
  for (int i = 0; i < ordered.size(); ++i)
    ordered[i] = std::move(legs[static_cast<std::size_t>(i / 2 + (i % 2 == 0 ? 0 : num_left))]);
  return ordered;
}

/// Legs are commanded by their names.
void refuse_equal_names(const LegArray<LegModel>& legs, Violations& violations) {
  for (LegId i = 0; i < legs.size(); ++i) {
    for (LegId j = 0; j < i; ++j) {
      if (legs[i].name == legs[j].name)
        violations.add("leg " + legs[i].name,
                       "is the name of two legs, that of joint " + legs[j].joint_names[0] +
                           " and that of joint " + legs[i].joint_names[0] +
                           "; what the joints' names of a leg begin with must be its own, as LF in "
                           "LF_yaw, LF_hip, LF_knee");
      else if (short_leg_name(legs[i].name) == short_leg_name(legs[j].name))
        violations.add(
            "leg " + legs[i].name,
            "and leg " + legs[j].name + " differ only by what actions may leave out, _leg or _LEG");
    }
  }
}

/// Recognises every chain as a leg. Counts legs only if all chains are, else one fault shows twice.
LegArray<LegModel> recognise_legs(const RobotTree& tree, Violations& violations) {
  std::vector<LegModel> legs;
  for (const SerialChain& chain : tree.chains)
    if (std::optional<LegModel> leg = recognise_leg(chain, violations))
      legs.push_back(*std::move(leg));
  if (legs.size() != tree.chains.size()) return {};

  if (legs.size() < 4 || legs.size() > kMaxLegs || legs.size() % 2 != 0) {
    violations.add("robot", "has " + std::to_string(legs.size()) +
                                " legs; need an even number from 4 to " + std::to_string(kMaxLegs));
    return {};
  }
  LegArray<LegModel> ordered = in_leg_order(std::move(legs), violations);
  refuse_equal_names(ordered, violations);
  return ordered;
}

std::string degrees(double radians) {
  return in_words(std::round(10.0 * radians * 180.0 / std::numbers::pi) / 10.0 + 0.0) + "°";
}

/// Which joints would be where beyond their limits with the foot at p_BC; if the limits are not
/// what keeps it from there, that.
std::string what_stops(const LegModel& leg) {
  LegModel free = leg;
  for (JointLimits& limits : free.limits) {
    limits.lower = -std::numbers::pi;
    limits.upper = std::numbers::pi;
  }
  const Reach reach = leg_reach(free);
  free.min_reach = reach.min;
  free.max_reach = reach.max;
  const auto solution = inverse_kinematics(free, leg.p_BC);
  if (!solution.reachable) return "the joint limits must allow it";
  std::string text;
  for (int i = 0; i < leg.num_joints(); ++i) {
    const JointLimits& limits = leg.limits[i];
    const double q = solution.q[i];
    if (limits.lower <= q && q <= limits.upper) continue;
    text += (text.empty() ? "joint " : ", joint ") + leg.joint_names[i] + " would be at " +
            degrees(q) + ", its limits are " + degrees(limits.lower) + " to " +
            degrees(limits.upper);
  }
  return text.empty() ? "the joint limits must allow it" : text;
}

/// Adds the workspace to a recognised leg.
void derive_workspace(LegModel& leg, Violations& violations) {
  if (leg.kind == LegKind::serial) return take_serial_stance(leg, violations);
  const Reach reach = leg_reach(leg);
  if (!(reach.min <= reach.max)) {
    violations.add("joint " + leg.joint_names[2],
                   "limits " + in_words(leg.limits[2].lower) + " to " +
                       in_words(leg.limits[2].upper) +
                       " rad never let the knee bend upwards; they must");
    return;
  }
  leg.min_reach = reach.min;
  leg.max_reach = reach.max;
  leg.p_BC = nominal_foot(leg);
  if (inverse_kinematics(leg, leg.p_BC).reachable) {
    leg.workspace_radius = reachable_radius(leg);
    return;
  }
  const Vector3 p_HC = leg.X_BH.inverse() * leg.p_BC;
  violations.add("leg " + leg.name, "cannot take its nominal stance: foot " + in_words(p_HC.x()) +
                                        " m out from the yaw axis, " + in_words(-p_HC.z()) +
                                        " m below the hip, yaw 0; " + what_stops(leg));
}

/// Mass and centre of mass in the nominal stance.
void sum_masses(RobotModel& robot) {
  Vector3 moment_B = robot.base.mass * robot.base.p_LM;
  robot.mass = robot.base.mass;
  for (const LegModel& leg : robot.legs) {
    const LegJoints q = inverse_kinematics(leg, leg.p_BC).q;
    for (int i = 0; i < leg.num_joints(); ++i) {
      const LinkModel& link = leg.links[i];
      robot.mass += link.mass;
      moment_B += link.mass * (link_pose(leg, i, q) * link.p_LM);
    }
  }
  robot.p_BM = moment_B / robot.mass;
}

}  // namespace

RobotModel load_urdf(const std::string& path) {
  return parse_urdf(read_text(path, kMaxUrdfText, "a URDF"), path);
}

RobotModel parse_urdf(const std::string& xml, const std::string& source) {
  Violations violations(source);
  std::optional<RobotTree> tree = read_robot_tree(xml, violations);
  if (!tree) violations.throw_if_any();

  RobotModel robot;
  robot.legs = recognise_legs(*tree, violations);
  robot.foot_radius = foot_radius(*tree, violations);
  violations.throw_if_any();

  for (LegModel& leg : robot.legs) derive_workspace(leg, violations);
  violations.throw_if_any();

  robot.name = std::move(tree->name);
  robot.base = std::move(tree->base);
  sum_masses(robot);
  robot.inertia_M_B = nominal_inertia(robot);
  return robot;
}

}  // namespace hexagait
