// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/plant/plant_watch.hpp>
#include <limits>

namespace hexagait {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
RobotModel robot_of(int legs) {
  RobotModel model;
  model.legs = LegArray<LegModel>(legs);
  return model;
}
const RobotModel kSix = robot_of(6);
const Measurement kGood{1.0, LegArray<LegJoints>(6, LegJoints::Zero()), LegArray<bool>(6, true)};

TEST(Measurement, IsValidIfCompleteAndFinite) {
  EXPECT_TRUE(valid(kGood, kSix));
  EXPECT_FALSE(valid(kGood, robot_of(4)));
  Measurement measurement = kGood;
  measurement.q[5][2] = kNaN;
  EXPECT_FALSE(valid(measurement, kSix));
  measurement = kGood;
  measurement.q[5][2] = -1.1e4;
  EXPECT_FALSE(valid(measurement, kSix)) << "no joint turns as far";
  measurement = kGood;
  measurement.time = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(valid(measurement, kSix));
  measurement = kGood;
  measurement.contact = LegArray<bool>(5);
  EXPECT_FALSE(valid(measurement, kSix));
}

// 0.1 s are 50 periods of 2 ms (which sum up to a little more or less).
TEST(PlantWatch, HoldsWhileThePlantIsLateAndStopsAfterTheLimit) {
  PlantWatch watch;
  for (int k = 0; k < 49; ++k)
    EXPECT_FALSE(watch.accepts(PlantStatus::late, kGood, kSix, 0.002, 0.1));
  EXPECT_TRUE(watch.holding());
  EXPECT_EQ(watch.fault(), Fault::none);
  EXPECT_TRUE(watch.accepts(PlantStatus::fresh, kGood, kSix, 0.002, 0.1));
  EXPECT_FALSE(watch.holding());
  for (int k = 0; k < 49; ++k) (void)watch.accepts(PlantStatus::late, kGood, kSix, 0.002, 0.1);
  EXPECT_EQ(watch.fault(), Fault::none) << "counted anew";
  for (int k = 0; k < 3; ++k) (void)watch.accepts(PlantStatus::late, kGood, kSix, 0.002, 0.1);
  EXPECT_EQ(watch.fault(), Fault::plant_late);
  EXPECT_FALSE(watch.accepts(PlantStatus::fresh, kGood, kSix, 0.002, 0.1)) << "for good";
}

TEST(PlantWatch, TakesAnEmergencyStopAfterItWasLate) {
  PlantWatch watch;
  watch.stop(Fault::plant_late);
  EXPECT_TRUE(watch.silent());
  watch.stop(Fault::bad_command);
  EXPECT_EQ(watch.fault(), Fault::plant_late);
  watch.stop(Fault::emergency_stop);
  EXPECT_EQ(watch.fault(), Fault::emergency_stop);
  EXPECT_FALSE(watch.silent());
}

TEST(PlantWatch, KeepsTheFirstFault) {
  PlantWatch watch;
  Measurement bad = kGood;
  bad.q[0][0] = kNaN;
  EXPECT_FALSE(watch.accepts(PlantStatus::fresh, bad, kSix, 0.002, 0.1));
  EXPECT_EQ(watch.fault(), Fault::bad_measurement);
  watch.stop(Fault::emergency_stop);
  EXPECT_FALSE(watch.accepts(PlantStatus::closed, kGood, kSix, 0.002, 0.1));
  EXPECT_EQ(watch.fault(), Fault::bad_measurement);
}

TEST(PlantWatch, StopsWhenThePlantIsClosed) {
  PlantWatch watch;
  EXPECT_FALSE(watch.accepts(PlantStatus::closed, kGood, kSix, 0.002, 0.1));
  EXPECT_EQ(watch.fault(), Fault::plant_closed);
}

}  // namespace
}  // namespace hexagait
