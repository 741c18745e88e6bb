// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/model/leg_weight.hpp>
#include <hexagait/params/best_stance.hpp>
#include <hexagait/text/text_file.hpp>
#include <hexagait/urdf/detail/body_frame.hpp>
#include <hexagait/urdf/detail/joint_limits.hpp>
#include <hexagait/urdf/detail/leg_order.hpp>
#include <hexagait/urdf/detail/leg_recognition.hpp>
#include <hexagait/urdf/detail/leg_stance.hpp>
#include <hexagait/urdf/detail/masses.hpp>
#include <hexagait/urdf/detail/rounded.hpp>
#include <hexagait/urdf/detail/selection.hpp>
#include <hexagait/urdf/detail/settled_feet.hpp>
#include <hexagait/urdf/detail/xml_size.hpp>
#include <hexagait/urdf/urdf.hpp>

namespace hexagait {
namespace {

constexpr double kLargestRobot = 10.0, kSmallestRobot = 0.01;  // [m]

/// Everything that the stages of recognition share.
struct Recognition {
  const UrdfOptions& options;
  UrdfFile file;
  Meshes meshes;
  Violations violations;
  std::vector<Substitution> substitutions = {};

  [[nodiscard]] const FileJoint& joint(int i) const { return file.joint(i); }
};

void scale_lengths(double scale, UrdfFile& file) {
  for (FileJoint& joint : file.joints) joint.X_PJ.p *= scale;
  for (FileLink& link : file.links) {
    if (link.inertial) {
      link.inertial->X_LM.p *= scale;
      if (link.inertial->inertia_M) *link.inertial->inertia_M *= scale * scale;
    }
    for (auto* shapes : {&link.collisions, &link.visuals})
      for (FileShape& shape : *shapes) shape.size *= scale, shape.X_LS.p *= scale;
  }
}

std::vector<std::optional<FoundFoot>> find_feet(Recognition& r, const RobotTree& tree) {
  std::vector<std::optional<FoundFoot>> feet;
  for (const SerialChain& chain : tree.chains)
    feet.push_back(find_foot(r.file, chain, r.meshes, r.options));
  return feet;
}

/// The tree of some chains, z upwards.
RobotTree upright_tree(const Recognition& r, const std::vector<JointChain>& chains,
                       const Matrix3& R_UR) {
  RobotTree tree = assemble(r.file, chains, r.options);
  if (R_UR != Matrix3::Identity()) move(tree, {R_UR, Vector3::Zero()});
  return tree;
}

Matrix3 find_up(Recognition& r, const std::vector<JointChain>& chains) {
  RobotTree tree = assemble(r.file, chains, r.options);
  for (SerialChain& chain : tree.chains) {
    const auto foot = find_foot(r.file, chain, r.meshes, r.options);
    const LinkModel& tip = chain.links.back();
    chain.foot = {tip.X_BL0 * (foot ? foot->p_LF : tip.p_LM), 0.0};
  }
  std::erase_if(tree.chains, [](const SerialChain& chain) { return chain.joints.size() < 2; });
  if (tree.chains.empty()) return Matrix3::Identity();
  return upright(tree, r.options, r.substitutions);
}

void leave_out(Recognition& r, int joint, const std::string& found, const std::string& option) {
  r.substitutions.push_back({Origin::left_out, "joint " + r.joint(joint).name, r.joint(joint).line,
                             "joint", found, "held at 0", option});
}

/// What moves in a leg, but not as a leg's joint may: a short travel is held, anything else refused.
void hold(Recognition& r, int index, double length) {
  constexpr double kShortTravel = 0.1;  // of the leg's length
  const FileJoint& joint = r.joint(index);
  const double travel = joint.upper.value_or(1e9) - joint.lower.value_or(-1e9);
  if (joint.turns()) return leave_out(r, index, "branches off a leg", "");
  if (joint.type == FileJoint::Type::prismatic && travel < kShortTravel * length)
    return leave_out(r, index, "slides by " + in_words(travel) + " m", "");
  r.violations.add(joint.line, "joint " + joint.name,
                   "moves, but is neither revolute nor continuous; a leg's joints must turn");
}

/// A chain that is a leg, and what in it can't be.
void check_leg(Recognition& r, const LegCandidate& candidate, const SerialChain& chain,
               const Verdict& verdict) {
  const FileJoint& first = r.joint(candidate.joints.front());
  if (!verdict.problem.empty())
    r.violations.add(first.line, "leg of joint " + first.name,
                     verdict.problem + ", or leave it out (--legs)");
  for (const int index : candidate.joints) {
    const FileJoint& joint = r.joint(index);
    const JointRange range = range_of(joint, index == candidate.joints.front(), r.options);
    const std::string element = "joint " + joint.name;
    if (!joint.mimics.empty())
      r.violations.add(joint.line, element,
                       "mimics " + joint.mimics + "; each joint needs its own motor");
    if (!range.problem.empty()) r.violations.add(joint.line, element, range.problem);
    if (!range.substituted.empty())
      r.substitutions.push_back({r.options.joint_range ? Origin::given : Origin::substituted,
                                 element, joint.line, "limits", range.substituted,
                                 in_words(range.lower) + " to " + in_words(range.upper) + " rad",
                                 "--joint-range"});
  }
  const double length = length_of(chain, chain.links.back().X_BL0.p);
  for (const int index : candidate.held) hold(r, index, length);
}

/// What is named by options must be there.
void check_names(Recognition& r, const RobotTree& tree) {
  for (const std::string& name : r.options.legs)
    if (std::ranges::none_of(tree.chains, [&](const SerialChain& chain) {
          return chain.joints.front().name == name;
        }))
      r.violations.add("--legs", "'" + name + "' is no joint that a chain begins with at the body");
  for (const auto& [name, place] : r.options.feet) {
    const auto ends_in_it = [&r, &name = name](const SerialChain& chain) {
      return std::ranges::any_of(chain.parts.back().parts, [&](const LinkParts::Part& part) {
        return r.file.link(part.link).name == name;
      });
    };
    if (std::ranges::none_of(tree.chains, ends_in_it))
      r.violations.add("--foot", "'" + name + "' is no last link of a chain, nor fixed to one");
  }
}

/// The chains of the legs, chosen among all; what is none is reported.
std::vector<JointChain> choose_legs(Recognition& r, const std::vector<LegCandidate>& candidates,
                                    const RobotTree& tree) {
  const std::vector<Verdict> verdicts = judge(r.file, tree, find_feet(r, tree), r.options);
  std::vector<JointChain> legs;
  for (const LegCandidate& candidate : candidates) {
    if (candidate.joints.empty()) {
      leave_out(r, candidate.held.front(), "has no joint that turns behind it", "");
      continue;
    }
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
      if (tree.chains[i].joints.front().index != candidate.joints.front()) continue;
      if (!verdicts[i].why_not.empty()) {
        leave_out(r, candidate.joints.front(), "is no leg: " + verdicts[i].why_not, "--legs");
      } else {
        legs.push_back(candidate.joints);
        check_leg(r, candidate, tree.chains[i], verdicts[i]);
      }
    }
  }
  return legs;
}

/// With what was left out: it may have been meant as a leg.
void check_number(Recognition& r, std::size_t legs) {
  if (4 <= legs && legs <= kMaxLegs && legs % 2 == 0) return;
  r.violations.add("robot", "has " + std::to_string(legs) +
                                " legs; need an even number from 4 to " + std::to_string(kMaxLegs));
  for (const Substitution& s : r.substitutions)
    if (s.origin == Origin::left_out)
      r.violations.add(s.line, s.element,
                       s.found + (s.option.empty() ? "" : " (" + s.option + ")"));
}

/// Of millimetres, and of other units that are no metres.
void check_size(Recognition& r, const RobotTree& tree) {
  const double size = size_of(tree);
  if (kSmallestRobot <= size && size <= kLargestRobot) return;
  const bool large = size > kLargestRobot;
  r.violations.add(
      "robot",
      "is " + in_words(size) +
          " m from its middle to the end of a leg; a URDF is in metres: if this " + "one is in " +
          (large ? "millimetres, --scale 0.001" : "kilometres, --scale 1000") + " reads it");
}

LegArray<LegModel> recognise_legs(Recognition& r, const RobotTree& tree) {
  std::vector<LegModel> legs;
  for (const SerialChain& chain : tree.chains) legs.push_back(recognise_leg(chain));
  LegArray<LegModel> ordered = in_leg_order(std::move(legs), r.violations);
  make_names_unique(ordered, r.substitutions);
  for (LegModel& leg : ordered) derive_stance(leg, r.violations, r.substitutions);
  const auto two = std::ranges::count_if(ordered, &LegModel::has_two_joints);
  if (two != 0 && two != ordered.size())
    r.violations.add("robot", "has " + std::to_string(two) +
                                  " legs of two joints, and others of more; all its legs must have "
                                  "two, or all more (--legs)");
  if (r.violations.empty()) share_ground(ordered, r.violations, r.substitutions);
  return ordered;
}

void report_meshes(Recognition& r) {
  for (const auto& [name, problem] : r.meshes.problems())
    r.substitutions.push_back({Origin::left_out, "mesh " + name, problem.line, "mesh", problem.text,
                               "what else the file says of the link", "--package"});
}

double total_mass(const RobotModel& robot) {
  double mass = robot.base.mass;
  for (const LegModel& leg : robot.legs)
    for (const LinkModel& link : leg.links) mass += link.mass;
  return mass;
}

/// The stance that the options ask for.
RobotModel in_requested_stance(RobotModel robot, const UrdfOptions& options) {
  if (options.stance == StanceRequest{}) return robot;
  robot = in_stance(robot, stance_at(robot, options.stance));
  robot.substitutions.push_back({Origin::given, "robot", 0, "stance", "that of the model",
                                 "body " + metres(robot.foot_radius - robot.legs[0].p_BC.z()) +
                                     " high, splay " + metres(options.stance.splay),
                                 "--body-height, --splay"});
  return robot;
}

/// From the file to the tree of its legs, in the body frame, with whatever it lacks.
RobotTree settled_tree(Recognition& r) {
  const LegCandidates candidates = leg_candidates(r.file);
  for (const int waist : candidates.waists)
    if (r.joint(waist).type != FileJoint::Type::floating)
      leave_out(r, waist, "moves the body's parts against each other", "");
  std::vector<JointChain> chains;
  for (const LegCandidate& candidate : candidates.chains)
    if (!candidate.joints.empty()) chains.push_back(candidate.joints);
  const Matrix3 R_UR = find_up(r, chains);
  const RobotTree whole = upright_tree(r, chains, R_UR);
  check_names(r, whole);
  const std::vector<JointChain> legs = choose_legs(r, candidates.chains, whole);
  check_number(r, legs.size());

  RobotTree tree = upright_tree(r, legs, R_UR);
  settle_feet(r.file, r.options, find_feet(r, tree), tree, r.violations, r.substitutions);
  if (!r.violations.empty())
    for (const auto& [name, problem] : r.meshes.problems())
      r.violations.add(problem.line, "mesh " + name, problem.text + " (--package)");
  r.violations.throw_if_any();
  check_size(r, tree);
  const Pose X_BU = body_frame(tree, r.options, r.substitutions);
  if (X_BU.R != Matrix3::Identity() || !X_BU.p.isZero(0.0)) move(tree, X_BU);
  settle_body_shape(r.file, r.meshes, tree, r.substitutions);
  settle_masses(r.file, r.options, tree, r.substitutions);
  settle_drives(r.file, r.options, tree, r.substitutions);
  return tree;
}

}  // namespace

RobotModel load_urdf(const std::string& path, const UrdfOptions& options) {
  return parse_urdf(read_text(path, kMaxUrdfText, "a URDF"), path, options);
}

RobotModel parse_urdf(const std::string& xml, const std::string& source,
                      const UrdfOptions& options) {
  Violations violations(source);
  std::optional<UrdfFile> file = read_urdf_file(xml, violations);
  if (!file) violations.throw_if_any();
  Recognition r{options, *std::move(file),
                Meshes(std::filesystem::path(source).parent_path().string(), options.packages),
                std::move(violations)};
  if (options.scale != 1.0) scale_lengths(options.scale, r.file);

  RobotTree tree = settled_tree(r);
  RobotModel robot;
  robot.name = r.file.name;
  robot.legs = recognise_legs(r, tree);
  r.violations.throw_if_any();
  robot.foot_radius = tree.chains.front().foot->radius;
  robot.base = std::move(tree.base);
  robot.mass = total_mass(robot);
  weigh(robot);
  report_meshes(r);
  robot.substitutions = std::move(r.substitutions);
  return in_requested_stance(in_best_stance(robot), options);
}

}  // namespace hexagait
