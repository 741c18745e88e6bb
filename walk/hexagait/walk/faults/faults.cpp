// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <hexagait/sim/random.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/violations.hpp>
#include <hexagait/walk/faults/faults.hpp>

namespace hexagait::walk {
namespace {

constexpr double kRounding = 1e-9;  // of a number of control periods

const PlantFaults& checked(const PlantFaults& faults, double control_dt) {
  if (!(control_dt > 0.0) || !std::isfinite(control_dt))
    throw InvalidInput("faults of the plant: control_dt [s]: " + hexagait::in_words(control_dt) +
                       " must be finite and positive");
  check(faults);
  return faults;
}

}  // namespace

std::span<const Imperfection<PlantFaults>> imperfections() {
  using F = PlantFaults;
  static constexpr Imperfection<F> kAll[] = {
      {"joint_noise", &F::joint_noise, PlantUnit::angle, 0.0, 0.2,
       "Noise of the joint readings, standard deviation"},
      {"joint_quantisation", &F::joint_quantisation, PlantUnit::angle, 0.0, 0.2,
       "Step of the joint readings"},
      {"joint_zero_error", &F::joint_zero_error, PlantUnit::angle, 0.0, 0.2,
       "Every joint's zero is off by this, up or down"},
      {"contact_bounce", &F::contact_bounce, PlantUnit::time, 0.0, 1.0,
       "Contacts rattle for so long after each change"},
      {"false_contacts", &F::false_contacts, PlantUnit::share, 0.0, 1.0,
       "Probability, per foot and tick, that an open contact reads closed"},
      {"missed_contacts", &F::missed_contacts, PlantUnit::share, 0.0, 1.0,
       "Probability, per foot and tick, that a closed contact reads open"},
      {"sensing_delay", &F::sensing_delay, PlantUnit::time, 0.0, 1.0,
       "Time from measuring to the controller"},
      {"command_delay", &F::command_delay, PlantUnit::time, 0.0, 1.0,
       "Time from the controller to the servos"},
      {"acceleration_noise", &F::acceleration_noise, PlantUnit::acceleration, 0.0, 10.0,
       "Noise of the inertial measurement unit's accelerometer, standard deviation"},
      {"acceleration_bias", &F::acceleration_bias, PlantUnit::acceleration, 0.0, 5.0,
       "Every axis of the accelerometer is off by this, up or down"},
      {"rate_noise", &F::rate_noise, PlantUnit::angular_rate, 0.0, 10.0,
       "Noise of the inertial measurement unit's gyroscope, standard deviation"},
      {"rate_bias", &F::rate_bias, PlantUnit::angular_rate, 0.0, 1.0,
       "Every axis of the gyroscope is off by this, up or down"},
      {"late_ticks", &F::late_ticks, PlantUnit::share, 0.0, 1.0,
       "Probability that a tick gets no measurement, and its targets are lost"}};
  return kAll;
}

void check(const PlantFaults& faults) {
  Violations violations("faults of the plant");
  check_ranges(violations, imperfections(), faults);
  violations.throw_if_any();
}

FaultyPlant::FaultyPlant(Plant& plant, const RobotModel& robot, const PlantFaults& faults,
                         double control_dt, std::uint64_t seed)
    : plant_(&plant),
      faults_(checked(faults, control_dt)),
      dt_(control_dt),
      seed_(seed),
      num_joints_(robot.num_legs()),
      zero_errors_(robot.num_legs(), LegJoints::Zero()),
      sensing_(delay(faults.sensing_delay)),
      command_(delay(faults.command_delay)),
      sensed_(sensing_.whole + 2),
      commanded_(command_.whole + 2),
      bounce_(robot.num_legs(), 0.0) {
  for (LegId leg = 0; leg < robot.num_legs(); ++leg) {
    num_joints_[leg] = robot.legs[leg].num_joints();
    for (int k = 0; k < num_joints_[leg]; ++k)
      zero_errors_[leg][k] = faults.joint_zero_error * (draw(Draw::zero, leg, k) < 0.5 ? -1 : 1);
  }
  for (int k = 0; k < 3; ++k) {
    imu_bias_.acceleration[k] =
        draw(Draw::bias, 0, k) < 0.5 ? -faults.acceleration_bias : faults.acceleration_bias;
    imu_bias_.rate[k] = draw(Draw::bias, 1, k) < 0.5 ? -faults.rate_bias : faults.rate_bias;
  }
}

// Uniform in [0, 1): a function of the arguments, the seed and the measurement's number.
double FaultyPlant::draw(Draw what, LegId leg, int joint, int more) const {
  constexpr std::uint64_t kOfAJoint = 4, kOfALeg = kMaxLegJoints * kOfAJoint;
  const auto channel = static_cast<std::uint64_t>(leg) * kOfALeg +
                       static_cast<std::uint64_t>(joint) * kOfAJoint +
                       static_cast<std::uint64_t>(more);
  return random_u01(seed_, RandomStream::sensors, static_cast<std::uint32_t>(what),
                    tick_ * kMaxLegs * kOfALeg + channel);
}

FaultyPlant::Delay FaultyPlant::delay(double seconds) const {
  const double periods = seconds / dt_, whole = std::floor(periods + kRounding);
  return {static_cast<std::size_t>(whole), std::max(0.0, periods - whole)};
}

PlantStatus FaultyPlant::read(Measurement& measurement) {
  Measurement now;
  const PlantStatus status = plant_->read(now);
  if (status != PlantStatus::fresh) return status;
  feel(now.contact);
  sensed_.push(now);
  late_ = tick_++ > 0 && draw(Draw::late, 0) < faults_.late_ticks;
  if (late_) return PlantStatus::late;

  measurement = delayed(now.time);
  misread(measurement.q);
  if (measurement.imu) misread(*measurement.imu);
  return PlantStatus::fresh;
}

void FaultyPlant::write(const JointTargets& targets) {
  JointTargets sent = late_ && !commanded_.empty() ? gone_on() : targets;
  if (faults_.positions_only) {
    sent.mode = {};
    for (LegId leg = 0; leg < sent.q.size(); ++leg) sent.qd[leg] = sent.effort[leg].setZero();
  }
  commanded_.push(sent);
  sent = arriving();
  if (faults_.joint_zero_error > 0.0)
    for (LegId leg = 0; leg < sent.q.size(); ++leg) sent.q[leg] -= zero_errors_[leg];
  plant_->write(sent);
}

// Contacts rattle from when they changed, at some time in the last control period.
void FaultyPlant::feel(LegArray<bool>& contact) {
  if (sensed_.empty()) touches_ = contact;
  for (LegId leg = 0; leg < contact.size(); ++leg) {
    if (contact[leg] != touches_[leg] && faults_.contact_bounce > 0.0)
      bounce_[leg] = faults_.contact_bounce / dt_ - draw(Draw::touch, leg);
    touches_[leg] = contact[leg];
    if (bounce_[leg] > 0.0) {
      contact[leg] = draw(Draw::bounce, leg) < 0.5;
      bounce_[leg] -= 1.0;
    }
    const double wrong = contact[leg] ? faults_.missed_contacts : faults_.false_contacts;
    const Draw lot = contact[leg] ? Draw::missed : Draw::false_one;
    if (wrong > 0.0 && draw(lot, leg) < wrong) contact[leg] = !contact[leg];
  }
}

// What was measured when what is read now was.
Measurement FaultyPlant::delayed(double time) const {
  Measurement measurement = sensed_.at(sensing_.whole);
  measurement.time = time;
  if (sensing_.rest == 0.0) return measurement;
  const Measurement& before = sensed_.at(sensing_.whole + 1);
  measurement.contact = before.contact;
  measurement.imu = before.imu;
  for (LegId leg = 0; leg < measurement.q.size(); ++leg)
    measurement.q[leg] += sensing_.rest * (before.q[leg] - measurement.q[leg]);
  return measurement;
}

// Of standard deviation 1.
double FaultyPlant::noise(Draw what, LegId leg, int joint) const {
  return bell(1.0, [&](int k) { return draw(what, leg, joint, k); });
}

void FaultyPlant::misread(InertialMeasurement& imu) const {
  imu.acceleration += imu_bias_.acceleration;
  imu.rate += imu_bias_.rate;
  for (int k = 0; k < 3; ++k) {
    if (faults_.acceleration_noise > 0.0)
      imu.acceleration[k] += faults_.acceleration_noise * noise(Draw::imu, 0, k);
    if (faults_.rate_noise > 0.0) imu.rate[k] += faults_.rate_noise * noise(Draw::imu, 1, k);
  }
}

void FaultyPlant::misread(LegArray<LegJoints>& q) const {
  const double step = faults_.joint_quantisation;
  for (LegId leg = 0; leg < num_joints_.size(); ++leg)
    for (int k = 0; k < num_joints_[leg]; ++k) {
      double& angle = q[leg][k];
      if (faults_.joint_zero_error > 0.0) angle += zero_errors_[leg][k];
      if (faults_.joint_noise > 0.0) angle += faults_.joint_noise * noise(Draw::noise, leg, k);
      if (step > 0.0) angle = step * std::round(angle / step);
    }
}

// What servos do that hear nothing: on at the velocities that they have.
JointTargets FaultyPlant::gone_on() const {
  JointTargets targets = commanded_.at(0);
  for (LegId leg = 0; leg < targets.q.size(); ++leg) targets.q[leg] += dt_ * targets.qd[leg];
  return targets;
}

JointTargets FaultyPlant::arriving() const {
  JointTargets targets = commanded_.at(command_.whole);
  if (command_.rest == 0.0) return targets;
  const JointTargets& before = commanded_.at(command_.whole + 1);
  targets.mode = before.mode;
  for (LegId leg = 0; leg < targets.q.size(); ++leg) {
    targets.q[leg] += command_.rest * (before.q[leg] - targets.q[leg]);
    targets.qd[leg] += command_.rest * (before.qd[leg] - targets.qd[leg]);
    targets.effort[leg] += command_.rest * (before.effort[leg] - targets.effort[leg]);
  }
  return targets;
}

}  // namespace hexagait::walk
