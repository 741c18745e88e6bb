// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/recording/json.hpp>
#include <nlohmann/json.hpp>

namespace hexagait::recording {
namespace {

WalkReport in_space() {
  WalkReport report{.robot = "argos", .simulation = {}, .summary = {}};
  report.simulation.trial.schedule = {{0.0, heading_control::Heading::straight(0.0)}};
  return report;
}

// One schema: whoever reads a walk reads a walk of Genghis, which has three keys of its own.
TEST(Json, OfGenghisHasEveryKeyOfAWalkAndOnlyItsReflexesBeside) {
  const auto walk = nlohmann::json::parse(to_json(in_space()));
  auto genghis = nlohmann::json::parse(to_json(report_of(sim2d::GenghisTrial{})));
  for (const char* own : {"underside_contact_s", "blocked_advances", "foothold_searches"})
    EXPECT_EQ(genghis.erase(own), 1U) << own;
  for (const auto& [key, value] : walk.items()) EXPECT_TRUE(genghis.contains(key)) << key;
  EXPECT_EQ(genghis.size(), walk.size());
}

TEST(Json, NamesItsSchemaAndSaysFellByTruthOrFalsehood) {
  WalkReport report = in_space();
  auto json = nlohmann::json::parse(to_json(report, {"w.png", "w.gp"}));
  EXPECT_EQ(json["schema"], kJsonSchema);
  EXPECT_EQ(json["fell"], false);
  EXPECT_EQ(json["files"].size(), 2U);
  report.summary.fell = true;
  json = nlohmann::json::parse(to_json(report));
  EXPECT_EQ(json["fell"], true);
  EXPECT_FALSE(json.contains("falls"));
}

TEST(Json, WritesNullForWhatIsNotKnown) {
  WalkReport report = in_space();
  report.summary.odometry_position = std::nan("");
  report.summary.margin_min = -std::numeric_limits<double>::infinity();
  const auto json = nlohmann::json::parse(to_json(report));
  EXPECT_TRUE(json["odometry_error"]["position_m"].is_null());
  EXPECT_TRUE(json["stability_margin_m"]["min"].is_null());
  EXPECT_TRUE(json["distance_asked_m"].is_null());
  EXPECT_TRUE(json["tripod_after_steps"].is_null());
}

}  // namespace
}  // namespace hexagait::recording
