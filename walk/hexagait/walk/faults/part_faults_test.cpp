// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/sim3d/world.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/walk/faults/part_faults.hpp>
#include <hexagait/walk/trial.hpp>
#include <testing/argos.hpp>
#include <testing/control_period.hpp>

// Each fault of a part, on a plant whose truth is known.
namespace hexagait::walk::part_faults_test {
namespace {

using testing::argos;
using ::testing::HasSubstr;
using testing::kDt;

constexpr double kLead = 0.2;
constexpr LegId kLF = 0, kRM = 3;

// Its joints are at 1 rad and its feet touch in every other period.
class KnownPlant final : public Plant {
 public:
  PlantStatus read(Measurement& measurement) override {
    measurement = {0.0, LegArray<LegJoints>(6, LegJoints::Constant(1.0)),
                   LegArray<bool>(6, periods % 2 == 1)};
    return PlantStatus::fresh;
  }
  void write(const JointTargets& targets) override {
    ++periods;
    written = targets;
  }
  int periods = 0;
  JointTargets written;
};

std::vector<PartFault> faults(std::initializer_list<const char*> texts) {
  std::vector<PartFault> all;
  for (const char* text : texts) all.push_back(parse_part_fault(text));
  return resolved(std::move(all), argos());
}

// A plant with faults that is read and written for some time of the walk.
struct Broken {
  explicit Broken(std::initializer_list<const char*> texts)
      : plant(known, faults(texts),
              {[this](LegId leg) { cut.push_back(leg); },
               [this](LegId leg, int joint, double share) {
                 weak = {leg + 0.0, joint + 0.0, share};
               },
               [this](const Vector2& force, double seconds) { impulse = force * seconds; }},
              kDt, kLead, 1) {}

  void go_on_until(double time) {
    for (; now < time - 0.5 * kDt; now += kDt) step();
  }
  void step() {
    plant.read(sensed);
    truth = known.periods % 2 == 1;
    plant.write({LegArray<LegJoints>(6, LegJoints::Zero()),
                 LegArray<LegJoints>(6, LegJoints::Ones()),
                 LegArray<LegJoints>(6, LegJoints::Ones()),
                 {}});
  }

  std::vector<LegId> cut;
  std::vector<double> weak;
  Vector2 impulse = Vector2::Zero();
  KnownPlant known;
  PartFaultPlant plant;
  Measurement sensed;
  bool truth = false;
  double now = -kLead;
};

std::string refusal(const char* text) {
  try {
    static_cast<void>(faults({text}));
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(PartFaults, WithoutAnyEverythingIsPassedOn) {
  Broken broken({});
  broken.go_on_until(0.01);
  EXPECT_EQ(broken.sensed.contact[kLF], broken.truth);
  EXPECT_EQ(broken.sensed.q[kLF][0], 1.0);
  EXPECT_EQ(broken.known.written.mode.size(), 0);
  EXPECT_EQ(broken.known.written.qd[kLF][0], 1.0);
}

// Times are those of the walk, which begins after the lead.
TEST(PartFaults, BeginAtTheirTimeOfTheWalk) {
  Broken broken({"dead:LF@50ms", "cut:RM@0", "push:50Ns:90deg@20ms", "weak:LF_knee:50%"});
  broken.go_on_until(0.0);
  EXPECT_TRUE(broken.cut.empty());
  EXPECT_EQ(broken.weak, (std::vector<double>{0, 2, 0.5})) << "from the beginning";
  broken.step();
  EXPECT_EQ(broken.cut, std::vector<LegId>{kRM});
  broken.now += kDt;
  broken.go_on_until(0.05);
  EXPECT_NEAR(broken.impulse.y(), 50.0, 1e-9);
  EXPECT_NEAR(broken.impulse.x(), 0.0, 1e-9);
  EXPECT_EQ(broken.known.written.mode[kLF], ControlMode::position);
  broken.step();
  EXPECT_EQ(broken.known.written.mode[kLF], ControlMode::effort);
  EXPECT_EQ(broken.known.written.effort[kLF][1], 0.0);
  EXPECT_EQ(broken.known.written.effort[1][1], 1.0) << "only that leg";
  EXPECT_EQ(broken.cut.size(), 1U) << "once";
}

TEST(PartFaults, OfContactsAreThoseOfOneFoot) {
  Broken on({"contact_on:LF"}), off({"contact_off:LF"}), late({"contact_late:LF:6ms"});
  for (int k = 0; k < 10; ++k) {
    for (Broken* broken : {&on, &off, &late}) broken->step();
    EXPECT_TRUE(on.sensed.contact[kLF]);
    EXPECT_FALSE(off.sensed.contact[kLF]);
    EXPECT_EQ(on.sensed.contact[kRM], on.truth);
    // Three periods late: what touches in every other period reads the other way round.
    if (k < 3) continue;
    EXPECT_EQ(late.sensed.contact[kLF], !late.truth);
  }
  Broken noisy({"contact_noise:LF:25%"});
  int wrong = 0;
  for (int k = 0; k < 4000; ++k) {
    noisy.step();
    wrong += noisy.sensed.contact[kLF] != noisy.truth ? 1 : 0;
  }
  EXPECT_NEAR(wrong, 1000, 5 * std::sqrt(750.0));
}

TEST(PartFaults, OfJointSensorsAreBiasAndNoise) {
  Broken broken({"bias:LF_hip:20mrad", "noise:RM_knee:10mrad"});
  double sum = 0.0, squares = 0.0;
  for (int k = 0; k < 4000; ++k) {
    broken.step();
    const double error = broken.sensed.q[kRM][2] - 1.0;
    sum += error;
    squares += error * error;
  }
  EXPECT_NEAR(broken.sensed.q[kLF][1], 1.02, 1e-12);
  EXPECT_NEAR(broken.known.written.q[kLF][1], -0.02, 1e-12) << "the servo believes it too";
  EXPECT_NEAR(sum / 4000, 0.0, 5 * 0.01 / std::sqrt(4000.0));
  EXPECT_NEAR(std::sqrt(squares / 4000), 0.01, 0.001);
}

// 15 kg at 0.3 m to the left of 32 kg: 15/47 of the way.
TEST(PartFaults, ALoadMovesTheBodysCentreOfMass) {
  const auto load = faults({"load:15kg:0:30cm"});
  const RobotModel loaded = with_loads(argos(), load);
  const Vector3 shift = loaded.base.p_LM - argos().base.p_LM;
  EXPECT_NEAR(loaded.base.mass, argos().base.mass + 15.0, 1e-9);
  EXPECT_NEAR(shift.y(), 15.0 / loaded.base.mass * (0.3 - argos().base.p_LM.y()), 1e-12);
  EXPECT_GT(loaded.base.inertia_M_L(0, 0), argos().base.inertia_M_L(0, 0));
}

// Of two that begin at once, and of one that comes later: from the next reading on.
TEST(PartFaults, CanBeAddedWhileItWalks) {
  KnownPlant known;
  PartFaultPlant plant(known, {}, {}, kDt, kLead, 1);
  const LegArray<LegJoints> none(6, LegJoints::Zero());
  Measurement sensed;
  for (int k = 0; k < 200; ++k) {
    plant.read(sensed);
    EXPECT_EQ(sensed.contact[kRM], known.periods % 2 == 1);
    plant.write({none, none, none, {}});
  }
  plant.add(faults({"contact_on:RM"})[0]);
  plant.add(faults({"dead:LF"})[0]);
  for (int k = 0; k < 4; ++k) {
    plant.read(sensed);
    EXPECT_TRUE(sensed.contact[kRM]);
    plant.write({none, none, none, {}});
    EXPECT_EQ(known.written.mode[kLF], ControlMode::effort);
    EXPECT_EQ(known.written.mode[kRM], ControlMode::position);
  }
}

TEST(PartFaults, NameWhatIsWrongAndWhatWouldBeRight) {
  EXPECT_THAT(refusal("ded:LF"), HasSubstr("did you mean 'dead'?"));
  EXPECT_THAT(refusal("dead"), HasSubstr("it must be dead:LEG"));
  EXPECT_THAT(refusal("dead:LX@5s"), HasSubstr("argos has no leg 'LX'"));
  EXPECT_THAT(refusal("dead:LX@5s"), HasSubstr("LF, RF, LM, RM, LR, RR"));
  EXPECT_THAT(refusal("weak:LF_kne:0.5"), HasSubstr("did you mean 'LF_knee'?"));
  EXPECT_THAT(refusal("weak:LF_knee:150%"), HasSubstr("'150%' must be a share from 0 to 1"));
  EXPECT_THAT(refusal("dead:LF@soon"), HasSubstr("a time such as"));
  EXPECT_THAT(refusal("dead:LF@-1s"), HasSubstr("before the walk"));
  EXPECT_THAT(refusal("load:15kg:0:0@3s"), HasSubstr("leave out the @"));
  EXPECT_THAT(refusal("push:50Ns:90grad@3s"), HasSubstr("30deg"));
  EXPECT_THAT(refusal("noise:LF_knee:1rad"), HasSubstr("0.2 rad"));
}

// A world with a leg cut off: five feet carry the robot, nothing is felt or moved of the sixth.
TEST(PartFaults, ACutLegIsGone) {
  const LegArray<LegJoints> q = nominal_posture(argos());
  sim3d::World world(argos(), {}, {}, q);
  const LegArray<LegJoints> none(6, LegJoints::Zero());
  for (int k = 0; k < 100; ++k) world.write({q, none, none, {}});
  world.cut(kRM);
  for (int k = 0; k < 250; ++k) world.write({q, none, none, {}});
  Measurement sensed;
  EXPECT_EQ(world.read(sensed), PlantStatus::fresh);
  EXPECT_FALSE(sensed.contact[kRM]);
  EXPECT_EQ(world.truth().feet[kRM].normal_force, 0.0);
  double force = 0.0;
  for (const FootTruth& foot : world.truth().feet) force += foot.normal_force;
  double leg_mass = 0.0;
  for (const LinkModel& link : argos().legs[kRM].links) leg_mass += link.mass;
  EXPECT_NEAR(force, (argos().mass - leg_mass) * kStandardGravity, 0.02 * force);
}

}  // namespace
}  // namespace hexagait::walk::part_faults_test
