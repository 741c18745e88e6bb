// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/recording/figures/terrain_figure.hpp>

namespace hexagait::recording {
namespace {

// Column of a table, of the rows that there are.
std::vector<double> column(const figures::Csv& table, std::size_t k) {
  std::vector<double> values;
  for (const auto& row : table.rows())
    if (!row.empty()) values.push_back(std::stod(row[k]));
  return values;
}

figures::Csv table_of(const char* terrain) {
  return ground_table(sim3d::Terrain(sim3d::parse_terrain(terrain), 3));
}

TEST(GroundTable, IsTheHeightOfTheTerrainOnAGrid) {
  const sim3d::Terrain terrain(sim3d::parse_terrain("boxes:20cm"), 3);
  const figures::Csv table = ground_table(terrain);
  const auto x = column(table, 0), y = column(table, 1), z = column(table, 2);
  ASSERT_EQ(x.size(), 109U * 61U);
  for (std::size_t k = 0; k < x.size(); ++k)
    EXPECT_NEAR(z[k], terrain.height_at(x[k], y[k]), 1e-8) << x[k] << " " << y[k];
}

TEST(GroundTable, PaintsIceAndSoftGround) {
  EXPECT_THAT(column(table_of("ice:0.1"), 3), ::testing::Contains(2.0));
  EXPECT_THAT(column(table_of("ice:0.1"), 3), ::testing::Contains(0.0));
  EXPECT_THAT(column(table_of("soft:20000"), 3), ::testing::Each(3.0));
  EXPECT_THAT(column(table_of("cliff:3m"), 3), ::testing::Contains(-1.0));
}

}  // namespace
}  // namespace hexagait::recording
