// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/plant/plant.hpp>
#include <hexagait/sim/imperfection.hpp>
#include <hexagait/walk/faults/history.hpp>
#include <span>

namespace hexagait::walk {

/// What sensors and bus do to what a controller sees and commands; the defaults do nothing. What is
/// wrong with the robot itself, its drives, masses and ground, is sim3d::WorldParams'.
struct PlantFaults {
  /// Standard deviation of white noise on every joint reading [rad]. Bell-shaped, never more than
  /// 3.5 times as much. The servos themselves have none.
  double joint_noise = 0.0;

  /// Step of the joint readings, which are rounded to it [rad]. A sensor of b bits has 2π/2ᵇ.
  double joint_quantisation = 0.0;

  /// Every joint's zero is off by so much, up or down by lot, for good [rad]: readings and targets
  /// alike, as of a sensor that was mounted so.
  double joint_zero_error = 0.0;

  /// After a foot touches or leaves the ground its contact reads open or closed by lot for so long
  /// [s]. When within a control period it touched is drawn.
  double contact_bounce = 0.0;

  /// Probability, per foot and control period, that an open contact reads closed.
  double false_contacts = 0.0;

  /// Probability, per foot and control period, that a closed contact reads open.
  double missed_contacts = 0.0;

  /// Time from measuring to reading, and from writing to the servos [s]. Between whole control
  /// periods joints are interpolated, and contacts are the older ones; `time` is that of reading.
  double sensing_delay = 0.0;
  double command_delay = 0.0;

  /// Standard deviation of white noise on every axis of the inertial measurement unit, and what every axis
  /// is off by, up or down by lot, for good [m/s²], [rad/s]. Noise as of the joints.
  double acceleration_noise = 0.0, acceleration_bias = 0.0;
  double rate_noise = 0.0, rate_bias = 0.0;

  /// Probability that a control period is late: nothing arrives, read() returns `late`, and what is
  /// written is lost. The servos go on with what they had, at its velocities.
  double late_ticks = 0.0;

  /// The bus carries positions only: no velocities and efforts, and every leg is driven by position.
  bool positions_only = false;

  friend bool operator==(const PlantFaults&, const PlantFaults&) = default;
};

/// The numbers of them, with their ranges.
[[nodiscard]] std::span<const Imperfection<PlantFaults>> imperfections();

/// @throws InvalidInput  listing everything that is out of its range, with name, unit and range
void check(const PlantFaults& faults);

/// A plant behind imperfect sensors and an imperfect bus:
///
///     read   q ─ delay ─▶ zero error ─▶ noise ─▶ rounding ─▶ controller
///            contact ─▶ bounce ─▶ false, missed ─ delay ─▶ controller
///            acceleration, rate ─ delay ─▶ bias ─▶ noise ─▶ controller
///     write  controller ─▶ positions only ─▶ late: lost ─ delay ─▶ zero error ─▶ servos
///
/// Ground truth is not touched. Deterministic: what is drawn is a function of seed, fault, control
/// period, leg and joint alone, so that a further fault changes no other. Without faults it passes
/// everything on, bit by bit. Allocates when it is made only.
class FaultyPlant final : public Plant {
 public:
  /// @param plant       must outlive this
  /// @param robot       whose legs and joints it has
  /// @param control_dt  control period: of one read() and write() [s]
  /// @throws InvalidInput  if a fault is out of its range, or control_dt is not positive
  FaultyPlant(Plant& plant, const RobotModel& robot, const PlantFaults& faults, double control_dt,
              std::uint64_t seed);

  /// The first measurement is never late.
  PlantStatus read(Measurement& measurement) override;
  void write(const JointTargets& targets) override;

 private:
  // A delay in control periods: whole ones, and the rest.
  struct Delay {
    std::size_t whole = 0;
    double rest = 0.0;
  };
  enum class Draw : std::uint32_t {
    zero = 1,
    noise,
    touch,
    bounce,
    false_one,
    missed,
    late,
    bias,
    imu
  };

  [[nodiscard]] double draw(Draw what, LegId leg, int joint = 0, int more = 0) const;
  [[nodiscard]] Delay delay(double seconds) const;
  void feel(LegArray<bool>& contact);
  [[nodiscard]] Measurement delayed(double time) const;
  [[nodiscard]] double noise(Draw what, LegId leg, int joint) const;
  void misread(LegArray<LegJoints>& q) const;
  void misread(InertialMeasurement& imu) const;
  [[nodiscard]] JointTargets gone_on() const;
  [[nodiscard]] JointTargets arriving() const;

  Plant* plant_;
  PlantFaults faults_;
  double dt_;
  std::uint64_t seed_;
  LegArray<int> num_joints_;
  LegArray<LegJoints> zero_errors_;
  InertialMeasurement imu_bias_;
  Delay sensing_, command_;
  std::uint64_t tick_ = 0;  // measurements taken so far
  bool late_ = false;       // the present control period
  History<Measurement> sensed_;
  History<JointTargets> commanded_;
  LegArray<bool> touches_;   // in truth, at the last reading
  LegArray<double> bounce_;  // how long each contact still rattles [control periods]
};

}  // namespace hexagait::walk
