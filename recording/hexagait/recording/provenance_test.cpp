// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/recording/detail/walk_json.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/urdf/urdf.hpp>
#include <testing/source_path.hpp>

namespace hexagait::recording {
namespace {

RobotModel argos() { return load_urdf(testing::source_path("robots/argos.urdf")); }

// Two spellings of the same URDF are one model; a change of any number makes another.
TEST(ModelHash, ChangesWithEveryNumberOfTheModelAndWithNothingElse) {
  const std::uint64_t hash = model_hash(argos());
  EXPECT_EQ(model_hash(argos()), hash);
  using Change = void (*)(RobotModel&);
  for (const Change change : {Change([](RobotModel& r) { r.legs[5].links[2].mass += 1e-12; }),
                              Change([](RobotModel& r) { r.legs[0].limits[1].velocity = 7.0; }),
                              Change([](RobotModel& r) { r.legs[3].axis_B0[2].y() *= -1.0; }),
                              Change([](RobotModel& r) { r.base.shapes.at(0).size.z() *= 2.0; }),
                              Change([](RobotModel& r) { r.foot_radius += 0.001; })}) {
    RobotModel other = argos();
    change(other);
    EXPECT_NE(model_hash(other), hash);
  }
}

TEST(Simulate, RefusesASimulationWithoutCommands) {
  EXPECT_THROW(static_cast<void>(simulate(argos(), Simulation{})), InvalidInput);
}

TEST(Provenance, NamesRobotPhysicsControllerAndLibraries) {
  Simulation simulation;
  simulation.physics_dt = 0.001;
  const Json json = hexagait::recording::json(provenance("argos", argos(), simulation));
  EXPECT_EQ(json["robots"][0]["name"], "argos");
  EXPECT_EQ(json["robots"][0]["model"].get<std::string>().size(), 16U);
  EXPECT_EQ(json["physics"]["physics_dt_s"], 0.001);
  EXPECT_EQ(json["physics"]["friction"], sim3d::WorldParams{}.friction);
  EXPECT_EQ(json["controller"]["step.stroke_m"], params_for(argos()).step.stroke);
  EXPECT_EQ(json["physics"]["plant.servo_kp_n_m_rad"], params_for(argos()).plant.servo_kp);
  for (const char* library : {"ODE", "Box2D", "Eigen", "yaml-cpp", "libc"})
    EXPECT_NE(json["libraries"][library], "") << library;
  EXPECT_TRUE(json["libraries"]["ODE"].get<std::string>().find("ODE") != std::string::npos);
  EXPECT_NE(json["revision"], "");
}

TEST(Provenance, OfGenghisHasItsOwnPhysicsAndController) {
  sim2d::GenghisTrial trial;
  trial.controller.clearance = 0.02;
  const Json json = hexagait::recording::json(provenance(trial));
  EXPECT_EQ(json["robots"][0]["name"], "genghis2d");
  EXPECT_EQ(json["physics"]["foot_friction"], sim2d::GenghisWorldParams{}.foot_friction);
  EXPECT_EQ(json["controller"]["clearance_m"], 0.02);
}

}  // namespace
}  // namespace hexagait::recording
