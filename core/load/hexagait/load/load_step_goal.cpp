// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <hexagait/load/detail/action_commands.hpp>
#include <hexagait/load/load_step_goal.hpp>
#include <hexagait/text/text_file.hpp>

namespace hexagait::action {
namespace {

constexpr std::string_view kGoalKeys[] = {"steps"};
constexpr std::string_view kOldStepKeys[] = {"step_number", "swing_data", "shift_data"};
constexpr std::string_view kSwingKeys[] = {"name", "surface_normal", "profile", "trajectory"};
constexpr std::string_view kSwingProfileKeys[] = {"target", "height", "duration", "type"};
constexpr std::string_view kShiftKeys[] = {"name", "profile", "trajectory"};
constexpr std::string_view kShiftProfileKeys[] = {"target", "duration"};

constexpr YamlKeys kGoalMap = {"goal", kGoalKeys};
constexpr YamlKeys kOldStepMap = {"step", kOldStepKeys};
constexpr YamlKeys kSwingMap = {"swing data", kSwingKeys};
constexpr YamlKeys kSwingProfileMap = {"swing profile", kSwingProfileKeys};
constexpr YamlKeys kShiftMap = {"shift data", kShiftKeys};
constexpr YamlKeys kShiftProfileMap = {"shift profile", kShiftProfileKeys};

/// When the base is shifted: before the swings, with them, after them.
const std::vector<std::string> kShifts = {"pre_step", "step", "post_step"};

struct LegWord {
  std::string name;
  LegId leg = 0;
};

// The names of the draft for a robot of n legs, and the robot's own. With six legs there is a
// middle; of eight or more the draft's names are those of the ends.
std::vector<LegWord> leg_words(const RobotModel& model) {
  const int n = model.num_legs();
  std::vector<LegWord> words = {
      {"leftFore", 0}, {"rightFore", 1}, {"leftHind", n - 2}, {"rightHind", n - 1}};
  if (n == 6) words.insert(words.end(), {{"leftMid", 2}, {"rightMid", 3}});
  for (LegId i = 0; i < n; ++i) words.push_back({model.legs[i].name, i});
  return words;
}

LegId read_old_leg(YamlReader& yaml, const std::vector<LegWord>& words, const YamlFields& fields) {
  std::vector<std::string> names;
  names.reserve(words.size());
  for (const LegWord& word : words) names.push_back(word.name);
  const std::optional<YamlField> field = yaml.require(fields, "name");
  if (!field) return 0;
  const std::optional<std::size_t> index = yaml.word(*field, names);
  return index ? words[*index].leg : 0;
}

bool is_empty(const YamlReader& yaml, const std::optional<YamlField>& field) {
  if (!field) return true;
  const YamlNode& node = yaml.node(field->node);
  return node.is_null() || (!node.is_scalar() && node.children.empty());
}

// A trajectory is used if it contains data.
bool has_knots(YamlReader& yaml, const YamlFields& fields) {
  const std::optional<YamlField> trajectory = yaml.find(fields, "trajectory");
  if (is_empty(yaml, trajectory)) return false;
  const YamlNode& node = yaml.node(trajectory->node);
  for (std::size_t i = 0; node.is_map() && i + 1 < node.children.size(); i += 2)
    if (yaml.node(node.children[i]).text == "knots") {
      const YamlNode& knots = yaml.node(node.children[i + 1]);
      return knots.is_scalar() || !knots.children.empty();
    }
  return true;
}

Direction read_old_normal(YamlReader& yaml, const ActionWords& words, const YamlField& field) {
  const YamlFields fields = yaml.fields(field, kNormalMap);
  const Vector3 v = yaml.vector_or(fields, "vector", Vector3::Zero());
  if (v.isZero(0.0)) return {};
  return read_normal(yaml, words, field);
}

// 0 is the default.
std::optional<double> number_but_0(YamlReader& yaml, const YamlFields& fields, std::string_view key,
                                   NumberRule rule) {
  const double value = yaml.number_or(fields, key, 0.0, rule);
  return value > 0.0 ? std::optional(value) : std::nullopt;
}

Footstep read_profile(YamlReader& yaml, const ActionWords& words, const LegMotion& motion,
                      const YamlField& field) {
  Footstep step{motion, {}};
  const YamlFields profile = yaml.fields(field, kSwingProfileMap);
  if (const auto target = yaml.require(profile, "target"))
    step.target = read_position(yaml, words, *target);
  step.profile_height =
      number_but_0(yaml, profile, "height", kHeight).value_or(step.profile_height);
  step.duration = number_but_0(yaml, profile, "duration", kTime);
  const std::optional<YamlField> type = yaml.find(profile, "type");
  const bool is_default =
      !type || (yaml.node(type->node).is_scalar() && yaml.node(type->node).text.empty());
  if (!is_default)
    if (const auto word = yaml.word(*type, kSwingProfiles))
      step.profile = static_cast<SwingProfile>(*word);
  return step;
}

LegCommand read_swing(YamlReader& yaml, const ActionWords& words,
                      const std::vector<LegWord>& leg_names, const YamlField& item) {
  const YamlFields fields = yaml.fields(item, kSwingMap);
  LegMotion motion;
  motion.leg = read_old_leg(yaml, leg_names, fields);
  const std::optional<YamlField> normal = yaml.find(fields, "surface_normal");
  if (!is_empty(yaml, normal)) motion.surface_normal = read_old_normal(yaml, words, *normal);
  if (has_knots(yaml, fields)) {
    EndEffectorTrajectory trajectory = read_foot_trajectory(yaml, words, fields);
    static_cast<LegMotion&>(trajectory) = motion;
    return {trajectory, item.mark};
  }
  const std::optional<YamlField> profile = yaml.require(fields, "profile");
  if (!profile) return {Footstep{motion, {}}, item.mark};
  return {read_profile(yaml, words, motion, *profile), item.mark};
}

// A target with a duration is a trajectory of one knot.
BaseCommand read_shift_profile(YamlReader& yaml, const ActionWords& words, const YamlField& field) {
  const YamlFields profile = yaml.fields(field, kShiftProfileMap);
  const std::optional<double> duration = number_but_0(yaml, profile, "duration", kTime);
  BaseTarget target;
  if (const auto pose = yaml.require(profile, "target")) {
    const YamlFields fields = yaml.fields(*pose, kPoseMap);
    target.frame = read_frame(yaml, words, fields);
    target.X_AB = read_pose(yaml, fields);
  }
  if (!duration) return {target, field.mark};
  return {BaseTrajectory{target.frame, {{*duration, target.X_AB}}}, field.mark};
}

BaseCommand read_shift(YamlReader& yaml, const ActionWords& words, const YamlFields& shift) {
  if (has_knots(yaml, shift)) return {read_pose_trajectory(yaml, words, shift), shift.mark};
  const std::optional<YamlField> profile = yaml.find(shift, "profile");
  if (is_empty(yaml, profile)) return {BaseAuto{}, shift.mark};
  return read_shift_profile(yaml, words, *profile);
}

class GoalReader {
 public:
  GoalReader(YamlReader& yaml, const ActionWords& words)
      : yaml_(yaml), words_(words), leg_words_(leg_words(words.model)) {}

  StepGoal read(const std::string& source) {
    goal_.action.id = std::filesystem::path(source).stem().string();
    goal_.action.source = source;
    const YamlFields fields = yaml_.fields({"goal", 0, {1, 1}}, kGoalMap);
    if (!yaml_.node(0).is_map()) return goal_;
    const std::optional<YamlField> steps = yaml_.require(fields, "steps");
    if (!steps) return goal_;
    const std::vector<YamlField> items = yaml_.list(*steps);
    if (items.empty() && yaml_.node(steps->node).is_list())
      yaml_.refuse(steps->mark, "steps: is empty; it must be a list of one step or more");
    if (items.size() > kMaxSteps / 3)
      yaml_.refuse(steps->mark, fmt::format("steps: has {} steps; at most {} are read",
                                            items.size(), kMaxSteps / 3));
    for (const YamlField& item : items) read_step(item);
    return goal_;
  }

 private:
  // Counts from 1, each larger than the one before.
  void read_step_number(const YamlFields& fields) {
    const std::optional<YamlField> field = yaml_.require(fields, "step_number");
    if (!field) return;
    const std::optional<double> number = yaml_.number(*field, kPositive);
    if (!number) return;
    const bool is_whole = *number <= 255.0 && *number == static_cast<int>(*number);
    if (!is_whole || *number <= number_ || (number_ == 0 && *number != 1.0))
      return yaml_.refuse(*field, number_ == 0 ? "1 in the first step"
                                               : fmt::format("a whole number from {} to 255, more "
                                                             "than that of the step before",
                                                             number_ + 1));
    number_ = static_cast<int>(*number);
  }

  void read_step(const YamlField& item) {
    const YamlFields fields = yaml_.fields(item, kOldStepMap);
    read_step_number(fields);
    Step parts[3];
    read_swings(fields, parts[1]);
    read_shifts(fields, parts);
    bool is_empty_step = true;
    for (Step& part : parts) {
      if (part.legs.empty() && !part.base) continue;
      is_empty_step = false;
      part.mark = item.mark;
      goal_.action.steps.push_back(std::move(part));
      goal_.step_numbers.push_back(number_);
    }
    if (is_empty_step)
      yaml_.refuse(item.mark, "step: is empty; it must have swing_data or shift_data");
  }

  void read_swings(const YamlFields& fields, Step& step) {
    const std::optional<YamlField> swings = yaml_.find(fields, "swing_data");
    if (is_empty(yaml_, swings)) return;
    for (const YamlField& item : yaml_.list(*swings)) {
      const std::size_t before = yaml_.num_refused();
      const LegCommand swing = read_swing(yaml_, words_, leg_words_, item);
      const LegId leg = leg_motion(swing).leg;
      for (const LegCommand& other : step.legs)
        if (yaml_.num_refused() == before && leg_motion(other).leg == leg)
          yaml_.refuse(
              item.mark,
              fmt::format("leg {} has swing data in this step already, at {}:{}",
                          words_.model.legs[leg].name, other.mark.line, other.mark.column));
      step.legs.push_back(swing);
      if (step.legs.size() > static_cast<std::size_t>(words_.model.num_legs())) return;
    }
  }

  void read_shifts(const YamlFields& fields, Step (&parts)[3]) {
    const std::optional<YamlField> shifts = yaml_.find(fields, "shift_data");
    if (is_empty(yaml_, shifts)) return;
    for (const YamlField& item : yaml_.list(*shifts)) {
      const YamlFields shift = yaml_.fields(item, kShiftMap);
      const std::optional<YamlField> name = yaml_.require(shift, "name");
      const std::size_t when = name ? yaml_.word(*name, kShifts).value_or(3) : 3;
      const BaseCommand command = read_shift(yaml_, words_, shift);
      if (when >= 3) continue;
      std::optional<BaseCommand>& base = parts[when].base;
      if (base)
        yaml_.refuse(name->mark, fmt::format("shift data {} stands in this step already, at {}:{}",
                                             kShifts[when], base->mark.line, base->mark.column));
      base = command;
    }
  }

  YamlReader& yaml_;
  const ActionWords& words_;
  std::vector<LegWord> leg_words_;
  StepGoal goal_;
  int number_ = 0;
};

}  // namespace

StepGoal parse_step_goal(const std::string& text, const std::string& source,
                         const RobotModel& model, const FrameNames& frames) {
  Violations violations(source);
  const YamlTree tree = parse_yaml(text, source, violations);
  YamlReader yaml(tree, violations);
  const ActionVocabulary vocabulary{frames, {}, {}};
  const ActionWords words = action_words(model, vocabulary);
  StepGoal goal = GoalReader(yaml, words).read(source);
  violations.throw_if_any();
  return goal;
}

StepGoal load_step_goal(const std::string& path, const RobotModel& model,
                        const FrameNames& frames) {
  return parse_step_goal(read_text(path, kMaxYamlText), path, model, frames);
}

}  // namespace hexagait::action
