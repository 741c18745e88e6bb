// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <hexagait/model/kinematics.hpp>
#include <hexagait/viewer/replay/walk_recorder.hpp>
#include <sstream>
#include <testing/argos_walk.hpp>
#include <vector>

namespace hexagait::viewer::walk_recorder_test {
namespace {

using heading_control::Heading;
using testing::argos;

// A wave gait from 1 s on.
recording::Simulation over_boxes() {
  recording::Simulation simulation;
  simulation.terrain = sim3d::parse_terrain("boxes:0.05");
  simulation.trial.seconds = 2.0;
  simulation.trial.schedule = {
      {.time = 0.0, .heading = Heading::arc(1.5, 0.0)},
      {.time = 1.0, .heading = Heading::arc(1.5, 0.0), .duty_factor = 0.75}};
  recording::complete(simulation, argos());
  return simulation;
}

struct Recorded {
  std::string bytes;
  walk::Summary summary;
  std::vector<GroundTruth> truth;  // after each tick
};

Recorded recorded(const recording::Simulation& simulation) {
  std::ostringstream out;
  WalkRecorder recorder(out, argos(), simulation);
  Recorded result;
  result.summary = simulate_in_world(
      argos(), simulation,
      [&](const auto& record, const GroundTruth& truth, const auto& referee, const auto& world) {
        recorder.observe(record, truth, referee, world);
        result.truth.push_back(truth);
      });
  recorder.finish();
  result.bytes = out.str();
  return result;
}

std::vector<PoseFrame> frames_of(const std::string& bytes) {
  std::vector<PoseFrame> frames;
  read_replay(bytes, {{}, [&](const PoseFrame& f) { frames.push_back(f); }});
  return frames;
}

// The k-th frame is of 20 ms · k after the first tick: 10 ticks of 2 ms each. Its joints put the feet where
// the truth has them, but for the flexible contact between sphere and ground and what is rounded.
TEST(WalkRecorder, ShowsTheTruthFiftyTimesASecond) {
  const Recorded walk = recorded(over_boxes());
  const std::vector<PoseFrame> frames = frames_of(walk.bytes);
  ASSERT_EQ(frames.size(), 100);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const PoseFrame& f = frames[k];
    const GroundTruth& truth = walk.truth[10 * k];
    EXPECT_NEAR(f.time, 0.02 * static_cast<double>(k), 1e-6);
    EXPECT_LT((f.X_WB.p - truth.X_WB.p).norm(), 2e-4);
    for (LegId i = 0; i < argos().num_legs(); ++i) {
      EXPECT_LT((f.legs[i].p_WF - truth.feet[i].p_WF).norm(), 2e-4);
      const Vector3 p_WF = f.X_WB * foot_position(argos().legs[i], f.legs[i].q);
      EXPECT_LT((p_WF - f.legs[i].p_WF).norm(), 1e-3) << "frame " << k << ", leg " << i;
      EXPECT_EQ(f.contact.contains(i), truth.feet[i].in_contact);
    }
  }
  EXPECT_GT(frames.back().path, 0.1);
  EXPECT_GT(frames.back().power, 1.0);
  EXPECT_EQ(frames[40].flags & PoseFrame::wave, 0);
  EXPECT_EQ(frames[60].flags & PoseFrame::wave, PoseFrame::wave);
}

TEST(WalkRecorder, WritesTheSameBytesOfTheSameWalk) {
  EXPECT_EQ(recorded(over_boxes()).bytes, recorded(over_boxes()).bytes);
}

// Whether somebody records it or not.
TEST(WalkRecorder, ChangesNothingOfTheWalk) {
  const walk::Summary alone = recording::simulate(argos(), over_boxes());
  EXPECT_EQ(recorded(over_boxes()).summary.state_hash, alone.state_hash);
}

TEST(WalkRecorder, HasTheSceneAndTheGroundBeforeTheFrames) {
  std::string order;
  read_replay(recorded(over_boxes()).bytes,
              {[&](std::string_view text) { order += text.find("\"scene\"") < 12 ? 's' : 'g'; },
               [&](const PoseFrame&) {
                 if (order.back() != 'f') order += 'f';
               }});
  EXPECT_EQ(order, "sgf");
}

}  // namespace
}  // namespace hexagait::viewer::walk_recorder_test
