// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstring>
#include <hexagait/plant/recorded_plant.hpp>
#include <hexagait/script/preview.hpp>
#include <testing/argos.hpp>

namespace hexagait {
namespace {

/// A foot is lifted, the body moves, the foot comes down.
action::Action some_action() {
  action::EndEffectorTarget paw;
  paw.leg = 1;
  paw.ignore_contact = true;
  paw.target = {kFootprint, {0.45, -0.45, 0.1}};
  action::Footstep back;
  back.leg = 1;
  back.target = {kFootprint, {0.45, -0.45, 0.0}};
  action::Action action;
  action.steps.resize(3);
  action.steps[0].legs.push_back({paw, {}});
  action.steps[1].base = action::BaseCommand{action::BaseAuto{.height = 0.33}, {}};
  action.steps[2].legs.push_back({back, {}});
  return action;
}

// The controller is a function of what it measured: played back, it writes the same bits.
TEST(RecordedPlant, MakesTheSameControllerWriteTheSameBits) {
  const RobotModel model = testing::argos();
  const auto run = [&](Plant& plant, const auto& observe) {
    ActionRunner runner(model);
    Measurement measurement;
    EXPECT_EQ(plant.read(measurement), PlantStatus::fresh);
    observe(measurement, JointTargets{});
    runner.start(measurement);
    runner.submit(some_action());
    while (!runner.idle()) {
      const PlantStatus status = plant.read(measurement);
      plant.write(runner.tick(status, measurement).desired.targets);
      observe(measurement, runner.record().desired.targets);
    }
    return runner.record().result;
  };

  std::vector<Measurement> measured;
  std::vector<JointTargets> written;
  PreviewPlant robot(nominal_joints(model), 0.002);
  const ActionResult first = run(robot, [&](const Measurement& measurement, const auto& targets) {
    measured.push_back(measurement);
    if (targets.q.size() > 0) written.push_back(targets);
  });
  ASSERT_GT(measured.size(), 500U);

  RecordedPlant recorded(measured);
  const ActionResult second = run(recorded, [](const auto&, const auto&) {});
  EXPECT_EQ(first.outcome, second.outcome);
  ASSERT_EQ(recorded.targets().size(), written.size());
  for (std::size_t k = 0; k < written.size(); ++k)
    for (LegId i = 0; i < 6; ++i)
      ASSERT_EQ(std::memcmp(&recorded.targets()[k].q[i], &written[k].q[i], sizeof(LegJoints)), 0);

  Measurement after;
  EXPECT_EQ(recorded.read(after), PlantStatus::closed);
}

}  // namespace
}  // namespace hexagait
