// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/model/kinematics.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>

#include "testing/robot_text.hpp"

namespace hexagait::testing {

using ::testing::HasSubstr;

/// What the loader says against a text; empty if nothing.
inline std::string refusal(const std::string& xml, const UrdfOptions& options = {}) {
  try {
    (void)parse_urdf(xml, "robot.urdf", options);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

/// "origin element what: found; used" of each substitution, a line each.
inline std::string told(const RobotModel& robot) {
  std::string text;
  for (const Substitution& s : robot.substitutions)
    text += fmt::format("{} {} {}: {}; {} {}\n", static_cast<int>(s.origin), s.element, s.what,
                        s.found, s.used, s.option);
  return text;
}

/// A robot that can stand: pairs that mirror each other, feet below hips, all on one level, limits and
/// masses that can be, and a ball at each foot.
inline void expect_sound(const RobotModel& robot, std::size_t legs) {
  ASSERT_EQ(robot.num_legs(), static_cast<int>(legs));
  EXPECT_GT(robot.foot_radius, 0.0);
  EXPECT_FALSE(robot.base.shapes.empty());
  for (LegId i = 0; i < robot.num_legs(); ++i) {
    const LegModel& leg = robot.legs[i];
    EXPECT_GT(leg.workspace_radius, 0.0) << leg.name;
    EXPECT_EQ(leg.X_BH.p.y() > 0.0, i % 2 == 0) << leg.name;
    EXPECT_LT(leg.p_BC.z(), leg.X_BH.p.z()) << leg.name;
    EXPECT_NEAR(leg.p_BC.z(), robot.legs[0].p_BC.z(), 1e-9) << leg.name;
    if (i >= 2) {
      EXPECT_LE(leg.X_BH.p.x(), robot.legs[i - 2].X_BH.p.x() + 1e-9);
    }
    const LegModel& partner = robot.legs[i ^ 1];
    EXPECT_NEAR(leg.p_BC.x(), partner.p_BC.x(), 1e-6) << leg.name;
    EXPECT_NEAR(leg.p_BC.y(), -partner.p_BC.y(), 1e-6) << leg.name;
    EXPECT_TRUE(inverse_kinematics(leg, leg.p_BC).reachable) << leg.name;
    for (const LinkModel& link : leg.links) EXPECT_GT(link.mass, 0.0) << link.name;
    const LinkModel& tip = leg.links.back();
    const auto is_ball = [&](const Shape& shape) {
      return shape.kind == Shape::Kind::sphere && shape.size.x() == robot.foot_radius &&
             (tip.X_BL0 * shape.X_LS.p - leg.p_BF0).norm() < 1e-12;
    };
    EXPECT_TRUE(std::ranges::any_of(tip.shapes, is_ball)) << leg.name;
  }
}

/// Loads it, and expects it to be sound and the substitutions to be told in these words.
inline RobotModel expect_recognised(const RobotText& robot,
                                    const std::vector<std::string>& words = {},
                                    const UrdfOptions& options = {}) {
  const std::string said = refusal(robot.text(), options);
  EXPECT_EQ(said, "");
  if (!said.empty()) return {};
  RobotModel model = parse_urdf(robot.text(), "robot.urdf", options);
  expect_sound(model, robot.hips.size());
  for (const std::string& word : words) EXPECT_THAT(told(model), HasSubstr(word));
  if (words.empty()) {
    EXPECT_EQ(told(model), "");
  }
  return model;
}

inline void expect_refused(const RobotText& robot, const std::vector<std::string>& words,
                           const UrdfOptions& options = {}) {
  const std::string said = refusal(robot.text(), options);
  for (const std::string& word : words) EXPECT_THAT(said, HasSubstr(word));
}

}  // namespace hexagait::testing
