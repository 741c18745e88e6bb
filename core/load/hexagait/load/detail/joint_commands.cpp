// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <hexagait/load/detail/action_commands.hpp>

namespace hexagait::action {
namespace {

// [i]: which joint of the leg, hip to foot, the i-th value is for.
using JointOrder = JointArray<int>;

JointOrder hip_to_foot(const LegModel& leg) {
  JointOrder order(leg.num_joints());
  for (int i = 0; i < order.size(); ++i) order[i] = i;
  return order;
}

// The keys under which values of joints stand, and where they belong.
struct JointKeys {
  std::string_view q, qd, qdd, effort;
};
constexpr JointKeys kPlural = {"positions", "velocities", "accelerations", "efforts"};
constexpr JointKeys kSingular = {"position", "velocity", "acceleration", "effort"};

LegJoints read_joints(YamlReader& yaml, const YamlFields& fields, std::string_view key,
                      const JointOrder& order, NumberRule rule) {
  LegJoints joints = LegJoints::Constant(JointKnot::kNone);
  const std::optional<YamlField> field = yaml.find(fields, key);
  if (!field) return joints;
  // Joints that the leg doesn't have are given too: as 0.
  joints.setZero();
  const std::size_t count = static_cast<std::size_t>(order.size());
  const std::optional<std::vector<double>> values = yaml.numbers(*field, {&count, 1}, rule);
  for (int i = 0; values && i < order.size(); ++i)
    joints[order[i]] = (*values)[static_cast<std::size_t>(i)];
  return joints;
}

JointKnot read_joint_state(YamlReader& yaml, const YamlFields& fields, const JointKeys& keys,
                           const JointOrder& order) {
  JointKnot knot;
  knot.q = read_joints(yaml, fields, keys.q, order, kAngle);
  knot.qd = read_joints(yaml, fields, keys.qd, order, kJointVelocity);
  knot.qdd = read_joints(yaml, fields, keys.qdd, order, kJointAcceleration);
  knot.effort = read_joints(yaml, fields, keys.effort, order, kEffort);
  return knot;
}

bool is_given(const LegJoints& joints) { return !std::isnan(joints[0]); }
bool says_nothing(const JointKnot& knot) {
  return !is_given(knot.q) && !is_given(knot.qd) && !is_given(knot.qdd) && !is_given(knot.effort);
}

// The joints in the order of the file: all of the leg, each once.
JointOrder read_joint_names(YamlReader& yaml, const LegModel& leg, const YamlField& field) {
  const std::vector<std::string> known(leg.joint_names.begin(), leg.joint_names.end());
  const std::vector<YamlField> names = yaml.list(field);
  if (!yaml.node(field.node).is_list()) return hip_to_foot(leg);
  if (names.size() != known.size()) {
    yaml.refuse(field, fmt::format("all joints of {}: {}", leg.name, fmt::join(known, ", ")));
    return hip_to_foot(leg);
  }
  JointOrder order(leg.num_joints(), -1);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = yaml.text(names[i]).value_or("");
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) {
      yaml.refuse_word(names[i].mark, fmt::format("joint of {}", leg.name), name, known);
      return hip_to_foot(leg);
    }
    const int joint = static_cast<int>(found - known.begin());
    if (std::find(order.begin(), order.end(), joint) != order.end()) {
      yaml.refuse(names[i].mark,
                  fmt::format("joint {} stands here a second time", in_quotes(name)));
      return hip_to_foot(leg);
    }
    order[static_cast<int>(i)] = joint;
  }
  return order;
}

JointKnot read_named_state(YamlReader& yaml, const LegModel& leg, const YamlField& field) {
  const YamlFields state = yaml.fields(field, kJointStateMap);
  const std::optional<YamlField> names = yaml.find(state, "joint_names");
  return read_joint_state(yaml, state, kPlural,
                          names ? read_joint_names(yaml, leg, *names) : hip_to_foot(leg));
}

// A quantity comes and goes at knots only if a curve can be drawn all the same.
void check_same_quantities(YamlReader& yaml, const Mark& mark, const JointKnot& knot,
                           const JointKnot& first) {
  const auto check = [&](std::string_view what, const LegJoints& a, const LegJoints& b) {
    if (is_given(a) != is_given(b))
      yaml.refuse(mark, fmt::format("{}: stand in some knots and not in others; it must be all or "
                                    "none",
                                    what));
  };
  check("positions", knot.q, first.q);
  check("efforts", knot.effort, first.effort);
  if (!is_given(first.q)) check("velocities", knot.qd, first.qd);
}

}  // namespace

JointTarget read_joint_target(YamlReader& yaml, const ActionWords& words,
                              const YamlFields& options) {
  JointTarget command{read_leg_motion(yaml, words, options), {}};
  const LegModel& leg = words.model.legs[command.leg];
  command.target = read_joint_state(yaml, options, kSingular, hip_to_foot(leg));
  const bool is_direct = !says_nothing(command.target);
  if (const auto target = yaml.find(options, "target")) {
    if (is_direct)
      yaml.refuse(target->mark,
                  "target: stands beside position, velocity, acceleration or effort; it must be "
                  "either");
    command.target = read_named_state(yaml, leg, *target);
  }
  if (says_nothing(command.target))
    yaml.refuse(options.mark,
                "joint_target: says nothing; it must have position, velocity, acceleration or "
                "effort, or a target with some of them");
  command.average_velocity =
      yaml.number_or(options, "average_velocity", command.average_velocity, kTurnRate);
  return command;
}

JointTrajectory read_joint_trajectory(YamlReader& yaml, const ActionWords& words,
                                      const YamlFields& options) {
  JointTrajectory command{read_leg_motion(yaml, words, options), {}};
  const std::optional<YamlField> field = yaml.require(options, "trajectory");
  if (!field) return command;
  const YamlFields trajectory = yaml.fields(*field, kLegTrajectoryMap);
  const std::optional<YamlField> names = yaml.require(trajectory, "joint_names");
  const LegModel& leg = words.model.legs[command.leg];
  const JointOrder order = names ? read_joint_names(yaml, leg, *names) : hip_to_foot(leg);
  for (const YamlField& item : read_knots(yaml, trajectory)) {
    const YamlFields fields = yaml.fields(item, kJointKnotMap);
    const double before = command.knots.empty() ? 0.0 : command.knots.back().time;
    JointKnot knot = read_joint_state(yaml, fields, kPlural, order);
    knot.time = read_time(yaml, fields, before);
    if (says_nothing(knot))
      yaml.refuse(item.mark,
                  "joint knot: says nothing; it must have positions, velocities, accelerations or "
                  "efforts");
    else if (!command.knots.empty())
      check_same_quantities(yaml, item.mark, knot, command.knots.front());
    command.knots.push_back(knot);
  }
  return command;
}

LegMode read_leg_mode(YamlReader& yaml, const ActionWords& words, const YamlFields& options) {
  LegMode command{read_leg_motion(yaml, words, options)};
  command.support_leg = yaml.flag_or(options, "support_leg", command.support_leg);
  command.duration = yaml.number_or(options, "duration", command.duration, kPositiveTime);
  return command;
}

}  // namespace hexagait::action
