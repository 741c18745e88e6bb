// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/model/kinematics.hpp>
#include <hexagait/params/params_for.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <map>
#include <testing/round_params.hpp>
#include <testing/source_path.hpp>

namespace hexagait {
namespace {

RobotModel load(const std::string& name) {
  return load_urdf(testing::source_path("robots/" + name + ".urdf"));
}

// The same robot s times as large, of the same material, with joints that are as fast in its own time.
LinkModel resized(LinkModel link, double s) {
  link.mass *= s * s * s;
  link.p_LM *= s;
  link.inertia_M_L *= s * s * s * s * s;
  link.X_BL0.p *= s;
  for (Shape& shape : link.shapes) {
    shape.size *= s;
    shape.X_LS.p *= s;
  }
  return link;
}

RobotModel resized(RobotModel robot, double s) {
  robot.base = resized(robot.base, s);
  robot.foot_radius *= s;
  robot.mass *= s * s * s;
  robot.p_BM *= s;
  for (LegModel& leg : robot.legs) {
    for (double* length :
         {&leg.coxa, &leg.femur, &leg.tibia, &leg.workspace_radius, &leg.min_reach, &leg.max_reach})
      *length *= s;
    for (Vector3* p : {&leg.X_BH.p, &leg.p_BF0, &leg.p_BC}) *p *= s;
    for (int k = 0; k < leg.num_joints(); ++k) {
      leg.limits[k].velocity /= std::sqrt(s);
      leg.limits[k].effort *= s * s * s * s;
      leg.links[k] = resized(leg.links[k], s);
      leg.p_BJ0[k] *= s;
    }
  }
  return robot;
}

// Of the unit: lengths grow with s, times with √s, masses with s³.
double power_of(const std::string& unit) {
  const std::map<std::string, double> powers = {
      {"m", 1.0},      {"s", 0.5}, {"m/s", 0.5},     {"m/s²", 0.0},      {"1/s", -0.5},
      {"rad/s", -0.5}, {"N", 3.0}, {"N m/rad", 4.0}, {"N m s/rad", 4.5}, {"m/(N s)", -2.5}};
  return powers.at(unit);
}

TEST(ParamsFor, OfArgosAreThoseItWasTunedWith) {
  RobotParams derived = params_for(load("argos")), tuned = testing::round_params();
  for (const Parameter& one : parameters()) {
    const double was = one.in(tuned);
    if (std::isinf(was)) continue;
    EXPECT_NEAR(one.in(derived), was, 0.10 * was) << one.name;
  }
}

// Nothing in them is a length, a time or a force of one robot: only the sensors have times of their own.
TEST(ParamsFor, AreTheSameForSimilarRobots) {
  for (const char* name : {"argos", "mite", "hexapod_mammal"}) {
    const RobotModel robot = load(name);
    RobotParams params = params_for(robot);
    for (const double s : {0.1, 2.0}) {
      RobotParams of_other = params_for(resized(robot, s));
      for (const Parameter& one : parameters()) {
        const double power = one.of == ScaleOf::none ? 0.0 : power_of(one.unit);
        const double expected = std::pow(s, power) * one.in(params);
        EXPECT_NEAR(one.in(of_other), expected, 1e-6 * expected) << name << s << one.name;
      }
    }
  }
}

TEST(ParamsFor, LeavesWhatIsSet) {
  RobotParams params;
  params.step.height = 0.04;
  const RobotModel robot = load("argos");
  params = completed(params, robot);
  EXPECT_EQ(params.step.height, 0.04);
  EXPECT_EQ(params.step.stroke, params_for(robot).step.stroke);
  for (const Parameter& one : parameters()) EXPECT_FALSE(is_derived(one.in(params))) << one.name;
}

// The joints' speeds at the rim of a swing's volume, by differences of the inverse kinematics.
TEST(ParamsFor, AskForNoMoreThanTheJointsCanDo) {
  for (const char* name :
       {"argos", "spider", "desktop", "mite", "octopod", "hexapod_mammal", "titan"}) {
    const RobotModel robot = load(name);
    const RobotParams params = params_for(robot);
    const RobotScale scale = scale_of(robot);
    const double r = 0.5 * params.step.stroke, h = params.step.height;
    // The body moves along with the foot.
    const double v = params.swing.max_speed - 0.33 * scale.reach / scale.time;
    for (const LegModel& leg : robot.legs) {
      for (int k = 0; k < 12; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 12, along = 1.3 * k;
        Vector3 p = leg.p_BC + Vector3(0.0, 0.0, h * (k % 3) / 2.0);
        p.head<2>() += r * unit_vector(angle);
        const LegSolution at = inverse_kinematics(leg, p);
        ASSERT_TRUE(at.reachable) << name << leg.name;
        constexpr double kTime = 1e-6;
        Vector3 next = p;
        next.head<2>() += v * kTime * unit_vector(along);
        const LegJoints qd = (inverse_kinematics(leg, next, at.q).q - at.q) / kTime;
        for (int j = 0; j < leg.num_joints(); ++j)
          EXPECT_LE(std::abs(qd[j]), 0.95 * leg.limits[j].velocity) << name << leg.joint_names[j];
      }
      // A hasty foot passes the centre, and the body has more of its speed.
      EXPECT_GE(params.swing.hasty_speed, params.swing.max_speed) << name;
      const double past = params.swing.hasty_speed - 1.4 * 0.33 * scale.reach / scale.time;
      for (int k = 0; k < 12; ++k) {
        const Vector3 p = leg.p_BC + Vector3(0.0, 0.0, h * (k % 3) / 2.0);
        const LegSolution at = inverse_kinematics(leg, p);
        constexpr double kTime = 1e-6;
        Vector3 next = p;
        next.head<2>() += past * kTime * unit_vector(2.0 * std::numbers::pi * k / 12);
        const LegJoints qd = (inverse_kinematics(leg, next, at.q).q - at.q) / kTime;
        for (int j = 0; j < leg.num_joints(); ++j)
          EXPECT_LE(std::abs(qd[j]), 0.95 * leg.limits[j].velocity) << name << leg.joint_names[j];
      }
    }
  }
}

// Slower joints: the same lengths. The times of a step grow until the joints follow a whole stroke;
// its fastest motions, by less, for these are bounded themselves: sideways by 0.9 of what the joints
// can do beside the body's own motion, upwards by max_rise.
TEST(ParamsFor, StretchTimesForSlowJointsAsLittleAsTheyMust) {
  RobotModel robot = load("argos");
  const RobotParams fast = params_for(robot);
  for (LegModel& leg : robot.legs)
    for (JointLimits& limits : leg.limits) limits.velocity *= 0.25;
  const RobotParams slow = params_for(robot);
  const RobotScale scale = scale_of(robot);
  const double pace = scale.reach / scale.time;
  EXPECT_EQ(slow.step.stroke, fast.step.stroke);
  EXPECT_EQ(slow.plant.servo_kd, fast.plant.servo_kd);
  const double stroke_peak = 1.875 * slow.step.stroke / slow.swing.transfer_time;
  EXPECT_NEAR(stroke_peak - 0.33 * pace, 0.9 * scale.sideways, 1e-9);
  EXPECT_NEAR(slow.swing.max_speed - 0.33 * pace, 0.9 * scale.sideways, 1e-9);
  EXPECT_LT(slow.swing.max_rise, 0.26 * fast.swing.max_rise);
}

// Joints that follow a stroke but not the fast rise: nothing else of the step waits for them.
TEST(ParamsFor, KeepTheTimesOfAStepWhoseRiseAloneIsSlow) {
  RobotModel robot = load("argos");
  const RobotParams fast = params_for(robot);
  for (LegModel& leg : robot.legs)
    for (int k = 1; k < 3; ++k) leg.limits[k].velocity *= 0.5;
  const RobotParams slow = params_for(robot);
  EXPECT_EQ(slow.swing.transfer_time, fast.swing.transfer_time);
  EXPECT_NEAR(slow.swing.max_rise, 0.5 * fast.swing.max_rise, 1e-9);
}

}  // namespace
}  // namespace hexagait
