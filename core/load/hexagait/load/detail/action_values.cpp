// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/load/detail/action_values.hpp>

namespace hexagait::action {
namespace {

Matrix3 from_roll_pitch_yaw(double roll, double pitch, double yaw) {
  return rotation_z(yaw) * rotation(Vector3(0, pitch, 0)) * rotation(Vector3(roll, 0, 0));
}

}  // namespace

ActionWords action_words(const RobotModel& model, const ActionVocabulary& vocabulary) {
  ActionWords words{model, vocabulary, vocabulary.frames.names(), {}};
  words.frames.emplace_back("base_link");
  for (const LegModel& leg : model.legs) words.legs.push_back(leg.name);
  return words;
}

LegId read_leg(YamlReader& yaml, const ActionWords& words, const YamlFields& fields) {
  const std::optional<YamlField> field = yaml.require(fields, "name");
  if (!field) return 0;
  const std::optional<std::string> name = yaml.text(*field);
  if (!name) return 0;
  for (const std::string_view candidate : {std::string_view(*name), short_leg_name(*name)}) {
    const auto found = std::find(words.legs.begin(), words.legs.end(), candidate);
    if (found != words.legs.end()) return static_cast<LegId>(found - words.legs.begin());
  }
  yaml.refuse_word(field->mark, "leg", *name, words.legs);
  return 0;
}

FrameId read_frame(YamlReader& yaml, const ActionWords& words, const YamlFields& fields,
                   std::string_view key) {
  const std::optional<YamlField> field = yaml.require(fields, key);
  if (!field) return kOdom;
  const std::optional<std::string> name = yaml.text(*field);
  if (!name) return kOdom;
  const std::optional<FrameId> frame = words.vocabulary.frames.find(*name);
  if (!frame) yaml.refuse_word(field->mark, "frame", *name, words.frames);
  return frame.value_or(kOdom);
}

Matrix3 read_orientation(YamlReader& yaml, const YamlField& field) {
  constexpr std::size_t kCounts[] = {3, 4};
  const std::optional<std::vector<double>> read = yaml.numbers(field, kCounts, kAngle);
  if (!read) return Matrix3::Identity();
  const std::vector<double>& v = *read;
  if (v.size() == 3) return from_roll_pitch_yaw(v[0], v[1], v[2]);

  const Eigen::Quaterniond quaternion(v[3], v[0], v[1], v[2]);
  const double length = quaternion.coeffs().stableNorm();
  if (!(std::abs(length - 1.0) <= 1e-3)) {
    yaml.refuse(field.mark, fmt::format("{}: is a quaternion of length {}; x, y, z, w must have "
                                        "length 1",
                                        field.key, in_words(length)));
    return Matrix3::Identity();
  }
  return quaternion.normalized().toRotationMatrix();
}

Pose read_pose(YamlReader& yaml, const YamlFields& fields) {
  Pose X;
  if (const auto position = yaml.require(fields, "position"))
    X.p = yaml.vector(*position, kPosition).value_or(X.p);
  if (const auto orientation = yaml.require(fields, "orientation"))
    X.R = read_orientation(yaml, *orientation);
  return X;
}

Position read_position(YamlReader& yaml, const ActionWords& words, const YamlField& field) {
  const YamlFields fields = yaml.fields(field, kPositionMap);
  Position target{read_frame(yaml, words, fields), Vector3::Zero()};
  if (const auto position = yaml.require(fields, "position"))
    target.p = yaml.vector(*position, kPosition).value_or(target.p);
  return target;
}

Direction read_normal(YamlReader& yaml, const ActionWords& words, const YamlField& field) {
  const YamlFields fields = yaml.fields(field, kNormalMap);
  Direction normal{read_frame(yaml, words, fields), Vector3::UnitZ()};
  if (const auto vector = yaml.require(fields, "vector")) {
    normal.v = yaml.vector(*vector).value_or(normal.v);
    if (!(normal.v.stableNorm() > 1e-6))
      yaml.refuse(vector->mark, "vector: is 0; a surface normal must have a direction");
  }
  return normal;
}

double read_time(YamlReader& yaml, const YamlFields& knot, double before) {
  const std::optional<YamlField> field = yaml.require(knot, "time");
  if (!field) return before;
  const std::optional<double> time = yaml.number(*field, kPositiveTime);
  if (!time) return before;
  if (*time - before < kSmallestQuantity)
    yaml.refuse(field->mark, fmt::format("time: is {} s; it must be later than the knot before, at "
                                         "{} s",
                                         in_words(*time), in_words(before)));
  return *time;
}

std::vector<YamlField> read_knots(YamlReader& yaml, const YamlFields& trajectory) {
  const std::optional<YamlField> field = yaml.require(trajectory, "knots");
  if (!field) return {};
  std::vector<YamlField> knots = yaml.list(*field);
  if (knots.empty() && yaml.node(field->node).is_list())
    yaml.refuse(field->mark, "knots: is an empty list; a trajectory needs at least one knot");
  return knots;
}

}  // namespace hexagait::action
