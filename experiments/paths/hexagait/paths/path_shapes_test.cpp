// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/params/params_for.hpp>
#include <hexagait/paths/path_shapes.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <hexagait/walk/paths/path_file.hpp>
#include <testing/source_path.hpp>

namespace hexagait::experiments {
namespace {

// To the four digits of the files.
TEST(PathShapes, AreThoseThatComeAlong) {
  const RobotModel robot = load_urdf(testing::source_path("robots/argos.urdf"));
  const double size = scale_of(robot).size;
  const auto expect_same = [&](const path_following::Path& made, const std::string& name) {
    const auto file =
        walk::load_path(testing::source_path("paths/" + name), robot, params_for(robot).step).path;
    ASSERT_NEAR(made.length(), file.length(), 1e-3 * size) << name;
    EXPECT_EQ(made.closed(), file.closed());
    for (int k = 0; k < 100; ++k)
      EXPECT_LT((made.at(0.01 * k * made.length()) - file.at(0.01 * k * file.length())).norm(),
                1e-3 * size)
          << name << ' ' << k;
  };
  expect_same(figure_eight(size), "figure_eight.yaml");
  expect_same(square(size), "square.yaml");
}

}  // namespace
}  // namespace hexagait::experiments
