// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/load/detail/action_keys.hpp>
#include <hexagait/load/load_action.hpp>
#include <numbers>

namespace hexagait::action {

// What numbers may be, with bounds that no robot with legs comes near, whatever its size. Of
// positions: the largest coordinates of UTM maps. Within them no curve overflows, and a wrong unit
// shows. What this robot can do is for the preview to say.

inline constexpr double kDay = 86'400.0;                           // [s]
inline constexpr double kHundredTurns = 200.0 * std::numbers::pi;  // [rad]

inline constexpr NumberRule kPosition{NumberRule::Bound::any, Dimension::length, 1e7};
inline constexpr NumberRule kHeight{NumberRule::Bound::not_negative, Dimension::length, 100.0};
inline constexpr NumberRule kTime{NumberRule::Bound::not_negative, Dimension::time, kDay};
inline constexpr NumberRule kPositiveTime{NumberRule::Bound::positive, Dimension::time, kDay};
inline constexpr NumberRule kAngle{NumberRule::Bound::any, Dimension::angle, kHundredTurns};
inline constexpr NumberRule kSpeed{NumberRule::Bound::positive, Dimension::number, 100.0};
inline constexpr NumberRule kVelocity{NumberRule::Bound::any, Dimension::number, 100.0};
inline constexpr NumberRule kAcceleration{NumberRule::Bound::any, Dimension::number, 1e4};
inline constexpr NumberRule kTurnRate{NumberRule::Bound::positive, Dimension::angular_rate, 1e4};
inline constexpr NumberRule kJointVelocity{NumberRule::Bound::any, Dimension::angular_rate, 1e4};
inline constexpr NumberRule kJointAcceleration{NumberRule::Bound::any, Dimension::angular_rate,
                                               1e6};
inline constexpr NumberRule kForce{NumberRule::Bound::any, Dimension::number, 1e6};
inline constexpr NumberRule kEffort{NumberRule::Bound::any, Dimension::number, 1e6};
inline constexpr NumberRule kPositive{NumberRule::Bound::positive};

/// In the order of SwingProfile.
inline const std::vector<std::string> kSwingProfiles = {"straight", "triangle", "square",
                                                        "trapezoid"};

/// The words that may stand for frames and legs.
struct ActionWords {
  const RobotModel& model;
  const ActionVocabulary& vocabulary;
  std::vector<std::string> frames;
  std::vector<std::string> legs;
};
[[nodiscard]] ActionWords action_words(const RobotModel& model, const ActionVocabulary& vocabulary);

// Values that several commands have. What is wrong is refused, and the default returned.

[[nodiscard]] LegId read_leg(YamlReader& yaml, const ActionWords& words, const YamlFields& fields);

/// A frame's name; also refused if it is not there.
[[nodiscard]] FrameId read_frame(YamlReader& yaml, const ActionWords& words,
                                 const YamlFields& fields, std::string_view key = "frame");

/// Roll, pitch, yaw or a quaternion x, y, z, w of length one (within 1e-3).
[[nodiscard]] Matrix3 read_orientation(YamlReader& yaml, const YamlField& field);

/// `position` and `orientation`, which must be there.
[[nodiscard]] Pose read_pose(YamlReader& yaml, const YamlFields& fields);

[[nodiscard]] Position read_position(YamlReader& yaml, const ActionWords& words,
                                     const YamlField& field);
[[nodiscard]] Direction read_normal(YamlReader& yaml, const ActionWords& words,
                                    const YamlField& field);

/// The time of a knot, which must be later than the one before it: 0 before the first.
[[nodiscard]] double read_time(YamlReader& yaml, const YamlFields& knot, double before);

/// The knots of a trajectory, at least one; refused and empty otherwise.
[[nodiscard]] std::vector<YamlField> read_knots(YamlReader& yaml, const YamlFields& trajectory);

}  // namespace hexagait::action
