// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/leg_weight.hpp>
#include <hexagait/model/serial_stance.hpp>
#include <hexagait/model/workspace.hpp>
#include <hexagait/urdf/detail/leg_recognition.hpp>
#include <hexagait/urdf/detail/robot_tree.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <sstream>

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
  return in_leg_order(std::move(legs), violations);
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
                                        " m below the hip, yaw 0; the joint limits must allow it");
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
  std::ifstream file(path);
  file.peek();  // fails here already if it is a directory
  if (!file.is_open() || file.bad()) {
    Violations violations(path);
    violations.add("file",
                   std::string("cannot be read (") + std::strerror(errno) + "); it must be a URDF");
    violations.throw_if_any();
  }
  std::stringstream text;
  text << file.rdbuf();
  return parse_urdf(text.str(), path);
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
