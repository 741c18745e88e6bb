// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/viewer/replay/replay_file.hpp>
#include <sstream>
#include <vector>

namespace hexagait::viewer::replay_file_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr int kLegs = 4;
constexpr const char* kScene =
    R"({"type":"scene","scene":1,"robot":"r","terrain":"flat","seed":7,"legs":[{},{},{},{}]})";
const LegArray<int> kJoints(kLegs, 3);

// The k-th frame of a robot that goes on and swings its legs; the number of corners changes.
PoseFrame frame_at(int k, int corners = 3) {
  PoseFrame f;
  f.scene = 1;
  f.tick = static_cast<std::uint32_t>(10 * k);
  f.time = 0.02 * k;
  f.X_WB.p = {0.0046 * k, -0.1, 0.31 + 0.001 * std::sin(0.3 * k)};
  f.X_WB.R = rotation({0.01, 0.02, 0.001 * k});
  f.velocity = {{0.2301, 0.0101}, -0.05};
  f.power = 31.0 + k;
  f.polygon.size = corners;
  for (int i = 0; i < corners; ++i)
    f.polygon.vertices[static_cast<std::size_t>(i)] = {0.1 * i, 0.0046 * k};
  f.legs = LegArray<LegFrame>(kLegs);
  for (LegId i = 0; i < kLegs; ++i) {
    f.legs[i].p_WF = {0.3 * i, 0.01 * k, 0.02};
    f.legs[i].force = 123.456;
    f.legs[i].q = leg_joints({0.1 * std::sin(0.2 * k), 0.5, -1.0 + 0.001 * k});
  }
  return f;
}

std::string written(int frames) {
  std::ostringstream out;
  ReplayWriter writer(out);
  writer.text(kScene);
  for (int k = 0; k < frames; ++k) writer.frame(frame_at(k, 3 + k % 2), kJoints);
  writer.finish();
  return out.str();
}

std::string problem_of(std::string_view bytes) {
  try {
    (void)check_replay(bytes);
    return "";
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

// More frames than are compressed together, of two lengths.
TEST(ReplayFile, GivesBackWhatWasWritten) {
  const int count = 600;
  std::vector<std::string> texts;
  int k = 0;
  const auto frame = [&](PoseFrame f) {
    PoseFrame expected = coarse(frame_at(k, 3 + k % 2));
    EXPECT_TRUE(f.X_WB.R.isApprox(expected.X_WB.R, 1e-4)) << k;
    f.X_WB.R = expected.X_WB.R;  // it is rounded again each time that it is encoded
    EXPECT_EQ(encode(f, kJoints), encode(expected, kJoints)) << k;
    ++k;
  };
  read_replay(written(count), {[&](std::string_view text) { texts.emplace_back(text); }, frame});
  EXPECT_EQ(k, count);
  EXPECT_THAT(texts, ElementsAre(kScene));
}

TEST(ReplayFile, KeepsTextsBetweenTheFramesThatTheyCameBetween) {
  std::ostringstream out;
  ReplayWriter writer(out);
  writer.text(kScene);
  writer.frame(frame_at(0), kJoints);
  writer.text("{}");
  writer.frame(frame_at(1), kJoints);
  writer.finish();
  std::string order;
  read_replay(out.view(),
              {[&](std::string_view) { order += 'T'; }, [&](const PoseFrame&) { order += 'F'; }});
  EXPECT_EQ(order, "TFTF");
}

TEST(ReplayFile, HasTheSameBytesForTheSameFrames) { EXPECT_EQ(written(300), written(300)); }

// Half of 2⁻¹³ m or rad, 2⁻¹⁶ of a quaternion, and a share of 2⁻⁸.
TEST(ReplayFile, RoundsLessThanCanBeSeen) {
  for (int k = 0; k < 50; ++k) {
    const PoseFrame exact = frame_at(k);
    const PoseFrame f = decode(encode(coarse(exact), kJoints));
    EXPECT_NEAR(f.time, exact.time, 1e-6);
    EXPECT_LT((f.X_WB.p - exact.X_WB.p).cwiseAbs().maxCoeff(), 6.2e-5);
    EXPECT_TRUE(f.X_WB.R.isApprox(exact.X_WB.R, 1e-4));
    EXPECT_NEAR(f.velocity.v.x(), exact.velocity.v.x(), 0.004 * exact.velocity.v.x());
    EXPECT_NEAR(f.power, exact.power, 0.004 * exact.power);
    for (LegId i = 0; i < kLegs; ++i) {
      EXPECT_LT((f.legs[i].q - exact.legs[i].q).cwiseAbs().maxCoeff(), 6.2e-5);
      EXPECT_TRUE(std::isnan(f.legs[i].p_WT.x()));
    }
  }
}

// A frame of four legs of three joints and three corners has 351 bytes.
TEST(ReplayFile, IsSmall) {
  const std::size_t frame = encode(frame_at(0), kJoints).size();
  EXPECT_EQ(frame, 351);
  EXPECT_LT(written(1500).size(), 1500 * frame / 15);
}

TEST(ReplayFile, TellsWhatIsInIt) {
  const ReplayFacts facts = check_replay(written(51));
  EXPECT_EQ(facts.robot, "r");
  EXPECT_EQ(facts.terrain, "flat");
  EXPECT_EQ(facts.seed, 7);
  EXPECT_EQ(facts.frames, 51);
  EXPECT_EQ(facts.scenes, 1);
  EXPECT_NEAR(facts.seconds, 1.0, 1e-9);
}

TEST(ReplayFile, ThatIsCutOffIsRefusedWhereverItIsCut) {
  const std::string bytes = written(300);
  for (std::size_t size = 1; size < bytes.size(); size += 1 + size / 40)
    EXPECT_THAT(problem_of(std::string_view(bytes).substr(0, size)), HasSubstr("is cut off"))
        << size;
  EXPECT_THAT(problem_of(std::string_view(bytes).substr(0, bytes.size() - 1)),
              HasSubstr("is cut off"));
}

TEST(ReplayFile, ThatIsNoneOrOfAnotherVersionIsRefused) {
  EXPECT_THAT(problem_of(""), HasSubstr("is no replay"));
  EXPECT_THAT(problem_of("time_s,x_m,y_m\n0,0,0\n"), HasSubstr("is no replay"));
  std::string bytes = written(3);
  bytes[8] = 2;
  EXPECT_EQ(problem_of(bytes), "is a replay of version 2; this hexagait reads version 1");
}

// All of its frames, one after the other.
std::string content_of(std::string_view bytes) {
  std::string all;
  read_replay(bytes, {{}, [&](const PoseFrame& f) { all += encode(f, kJoints); }});
  return all;
}

// The checksum, the sizes of the items or their content tell. A bit may change nothing: one zero is copied
// from another place than before.
TEST(ReplayFile, ThatIsDamagedIsRefused) {
  const std::string bytes = written(40), content = content_of(bytes);
  int told = 0;
  for (std::size_t at = 12 + 10; at < bytes.size(); ++at) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    if (problem_of(damaged).empty()) {
      EXPECT_EQ(content_of(damaged), content) << at;
    } else {
      ++told;
    }
  }
  EXPECT_GT(told, 0.9 * static_cast<double>(bytes.size()));
  EXPECT_THAT(problem_of(bytes + "more"), HasSubstr("more behind its end"));
}

// Both were found by the fuzzer.
TEST(ReplayFile, WithAFrameBeforeItsSceneOrAtNoTimeIsRefused) {
  const auto with_scene_and_time = [](bool scene, double time) {
    std::ostringstream out;
    ReplayWriter writer(out);
    if (scene) writer.text(kScene);
    PoseFrame frame = frame_at(0);
    frame.time = time;
    writer.frame(frame, kJoints);
    writer.finish();
    return problem_of(out.str());
  };
  EXPECT_EQ(with_scene_and_time(true, 1.0), "");
  EXPECT_THAT(with_scene_and_time(false, 1.0), HasSubstr("a frame before its scene"));
  for (const double time : {-1.0, 1e300, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_THAT(with_scene_and_time(true, time), HasSubstr("is damaged: a frame at")) << time;
}

TEST(ReplayFile, WithoutFramesOrWithThoseOfAnotherRobotIsRefused) {
  EXPECT_THAT(problem_of(written(0)), HasSubstr("nothing has moved"));
  std::ostringstream out;
  ReplayWriter writer(out);
  writer.text(R"({"type":"scene","robot":"r","terrain":"flat","seed":7,"legs":[{},{}]})");
  writer.frame(frame_at(0), kJoints);
  writer.finish();
  EXPECT_THAT(problem_of(out.view()), HasSubstr("a frame of 4 legs, of a robot that has 2"));
}

}  // namespace
}  // namespace hexagait::viewer::replay_file_test
