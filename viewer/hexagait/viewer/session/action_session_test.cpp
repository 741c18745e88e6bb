// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/text/text_file.hpp>
#include <hexagait/viewer/session/session.hpp>
#include <nlohmann/json.hpp>
#include <testing/argos_walk.hpp>
#include <testing/session_client.hpp>
#include <testing/source_path.hpp>

// Scripted actions of a session, in time that runs ten times as fast as the machine's.
namespace hexagait::viewer {
namespace {

using heading_control::Heading;
using Json = nlohmann::json;
using ::testing::HasSubstr;
using testing::held_until;
using ::testing::IsEmpty;

constexpr const char* kPaw = R"({"type":"action","action":"paw"})";

class ActionSession : public ::testing::Test {
 protected:
  ActionSession() : client_(session_.enter()) {}

  static SessionOptions options() {
    SessionOptions result;
    result.robot = testing::argos();
    result.simulation = testing::on("flat");
    result.heading = Heading::straight(0.0);
    result.speed_factor = 10.0;
    result.robots = {"argos", "mite"};
    result.load = [](const std::string& name) {
      return LoadedRobot{load_urdf(hexagait::testing::source_path("robots/" + name + ".urdf")), {}};
    };
    result.actions = {"wave", "paw", "height"};
    result.load_action = [](const std::string& name) {
      return read_text(hexagait::testing::source_path("actions/" + name + ".yaml"), 100'000);
    };
    return result;
  }

  std::string send(const std::string& message) { return session_.receive(client_, message); }
  std::string send_yaml(const std::string& yaml) {
    return send(Json{{"type", "action"}, {"yaml", yaml}, {"name", "my.yaml"}}.dump());
  }

  // The first news of the action that is as wanted; the client goes on holding the wheel.
  template <class Wanted>
  Json news_when(Wanted wanted) {
    Session::Letter letter;
    std::string last = "none";
    for (int k = 0; k < 3000; ++k) {
      if (beats_) {
        EXPECT_THAT(send(R"({"type":"beat"})"), IsEmpty());
      }
      Session::Seen seen;
      while (session_.newer_than(seen, letter)) {
        if (letter.kind != Session::Mail::action) continue;
        last = letter.content;
        if (const Json news = Json::parse(last); wanted(news)) return news;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ADD_FAILURE() << "no such news; the last: " << last;
    return Json{{"state", "none"}, {"why", ""}, {"findings", Json::array()}};
  }
  Json news(const std::string& state) {
    return news_when([&](const Json& news) { return news["state"] == state; });
  }
  // With its paw in the air.
  void raise_paw() {
    EXPECT_THAT(send(kPaw), IsEmpty());
    news_when([](const Json& news) { return news["state"] == "running" && news["step"] >= 3; });
  }
  PoseFrame frame(bool (*wanted)(const PoseFrame&)) {
    return held_until(session_, client_, wanted);
  }
  std::string notice() {
    Session::Letter letter;
    for (int k = 0; k < 500; ++k) {
      Session::Seen seen;
      while (session_.newer_than(seen, letter))
        if (letter.kind == Session::Mail::notice) return letter.content;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return "no notice";
  }
  static bool walks(const PoseFrame& f) { return f.moving && f.path > 0.0; }

  Session session_{options()};
  ClientId client_;
  bool beats_ = true;
};

TEST_F(ActionSession, PerformsAnActionOfTheListAndWalksAgain) {
  EXPECT_THAT(send(kPaw), IsEmpty());
  const Json running =
      news_when([](const Json& news) { return news["state"] == "running" && news["step"] >= 3; });
  EXPECT_EQ(running["name"], "paw");
  EXPECT_GT(running["steps"], 3);
  const PoseFrame f = frame([](const PoseFrame& g) { return !g.contact.contains(1); });
  EXPECT_GT(f.legs[1].p_WF.z(), 0.1);
  EXPECT_FALSE(f.moving);
  const Json done = news("done");
  EXPECT_EQ(done["step"], done["steps"]);
  EXPECT_THAT(send(R"({"type":"drive","curvature":0})"), IsEmpty());
  const double before = session_.statistics().path;
  for (int k = 0; k < 300 && session_.statistics().path < before + 0.2; ++k)
    frame(walks), std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_GT(session_.statistics().path, before + 0.2);
  EXPECT_FALSE(session_.statistics().fell);
}

TEST_F(ActionSession, PerformsAnActionOfTheClientsOwn) {
  EXPECT_THAT(send_yaml("steps:\n- step:\n  - base_auto: {height: 0.25}\n"), IsEmpty());
  EXPECT_EQ(news("done")["name"], "my.yaml");
}

TEST_F(ActionSession, RefusesAnActionWithErrorsAndWalksOn) {
  EXPECT_THAT(send_yaml("steps:\n- step:\n  - base_auto: {hieght: 0.2}\n"), IsEmpty());
  const Json refused = news("refused");
  EXPECT_EQ(refused["name"], "my.yaml");
  ASSERT_EQ(refused["findings"].size(), 1U);
  const Json& finding = refused["findings"][0];
  EXPECT_EQ(finding["line"], 3);
  EXPECT_EQ(finding["column"], 17);
  EXPECT_EQ(finding["error"], true);
  EXPECT_EQ(finding["source"], "  - base_auto: {hieght: 0.2}");
  const PoseFrame f = frame(walks);
  EXPECT_EQ(f.scene, 1U);
}

// What a client sends names no file: neither an action, nor the robot that it is written for.
TEST_F(ActionSession, NamesNoFiles) {
  EXPECT_THAT(send(R"({"type":"action","action":"../../etc/passwd"})"),
              HasSubstr("there is no action"));
  const std::string robot = hexagait::testing::source_path("robots/argos.urdf");
  EXPECT_THAT(send_yaml("robot: " + robot + "\nsteps:\n- step:\n  - base_auto:\n"), IsEmpty());
  const Json refused = news("refused");
  EXPECT_THAT(refused["findings"][0]["text"].get<std::string>(),
              HasSubstr("none of those that can be chosen"));
}

TEST_F(ActionSession, StopsInTheMiddle) {
  raise_paw();
  EXPECT_THAT(send(R"({"type":"stop"})"), IsEmpty());
  news("stopped");
  EXPECT_FALSE(frame([](const PoseFrame& f) { return f.contact.size() == 6; }).moving);
}

TEST_F(ActionSession, EndsWithACommandToWalkWhichIsObeyed) {
  raise_paw();
  EXPECT_THAT(send(R"({"type":"drive","curvature":0.5})"), IsEmpty());
  news("stopped");
  frame([](const PoseFrame& f) { return f.moving && f.k > 0.1; });
}

TEST_F(ActionSession, EndsWhenTheHolderFallsSilent) {
  EXPECT_THAT(send(R"({"type":"speed","factor":2})"), IsEmpty());
  raise_paw();
  beats_ = false;
  news("stopped");
}

TEST_F(ActionSession, IsHeldByAnEmergencyStop) {
  raise_paw();
  const ClientId bystander = session_.enter();
  EXPECT_THAT(session_.receive(bystander, R"({"type":"estop"})"), IsEmpty());
  EXPECT_THAT(news("stopped")["why"], "by the emergency stop");
  EXPECT_FALSE(frame([](const PoseFrame& f) { return f.fault == 5; }).contact.contains(1));
  EXPECT_THAT(send(kPaw), HasSubstr("the emergency stop holds the robot"));
  EXPECT_THAT(send(R"({"type":"release_estop"})"), IsEmpty());
  frame([](const PoseFrame& f) { return f.fault == 0 && f.contact.size() == 6; });
}

TEST_F(ActionSession, EndsWithItsScene) {
  raise_paw();
  EXPECT_THAT(send(R"({"type":"scramble"})"), IsEmpty());
  EXPECT_THAT(news("stopped")["why"], "the robot was put down anew");
  EXPECT_EQ(frame([](const PoseFrame& f) { return f.scene == 2; }).fault, 0);
}

// Checking the one takes some time: 30 000 ticks played ahead.
TEST_F(ActionSession, ChecksOneAtATimeAndDropsItWithAStop) {
  const std::string slow = "steps:\n- step:\n  - wait: {duration: 290}\n";
  EXPECT_THAT(send_yaml(slow), IsEmpty());
  news("checking");
  EXPECT_THAT(send(kPaw), IsEmpty());
  EXPECT_THAT(notice(), HasSubstr("another action is being checked"));
  EXPECT_THAT(send(R"({"type":"stop"})"), IsEmpty());
  EXPECT_EQ(news("stopped")["name"], "my.yaml");
}

TEST_F(ActionSession, IsRefusedInARace) {
  EXPECT_THAT(send(R"({"type":"race","on":true,"gait":"tripod"})"), IsEmpty());
  EXPECT_THAT(send(kPaw), IsEmpty());
  EXPECT_THAT(notice(), HasSubstr("end the race"));
}

TEST_F(ActionSession, NeedsTheWheel) {
  EXPECT_THAT(send(R"({"type":"beat"})"), IsEmpty());
  EXPECT_THAT(send(R"({"type":"stop"})"), IsEmpty());
  EXPECT_THAT(session_.receive(session_.enter(), kPaw), HasSubstr("another page holds the wheel"));
}

// A session that ends while it checks does not wait for the check.
TEST(ActionSessionEnd, DoesNotWaitForTheCheck) {
  auto session = std::make_unique<Session>([] {
    SessionOptions result;
    result.robot = testing::argos();
    result.simulation = testing::on("flat");
    return result;
  }());
  const std::string yaml = "steps:\n- step:\n  - wait: {duration: 290}\n";
  EXPECT_THAT(session->receive(session->enter(),
                               Json{{"type", "action"}, {"yaml", yaml}, {"name", "a"}}.dump()),
              IsEmpty());
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const auto begin = Clock::now();
  session = nullptr;
  EXPECT_LT(Clock::now() - begin, std::chrono::seconds(1));
}

}  // namespace
}  // namespace hexagait::viewer
