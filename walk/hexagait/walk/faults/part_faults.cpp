// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <hexagait/math/planar.hpp>
#include <hexagait/sim/random.hpp>
#include <hexagait/walk/faults/part_faults.hpp>

namespace hexagait::walk {
namespace {

using Kind = PartFaultKind;

constexpr double kPushTime = 0.1;  // [s]

// Streams of PlantFaults are lower numbers.
constexpr std::uint32_t kFirstTrial = 1000;

// A point mass, fixed to a link: mass, centre and inertia of both.
void add_load(LinkModel& link, double mass, const Vector3& p_LP) {
  const double both = link.mass + mass;
  const Vector3 way = p_LP - link.p_LM;
  const double reduced = both > 0.0 ? link.mass * mass / both : 0.0;
  link.inertia_M_L += reduced * (way.squaredNorm() * Matrix3::Identity() - way * way.transpose());
  if (both > 0.0) link.p_LM += mass / both * way;
  link.mass = both;
}

}  // namespace

RobotModel with_loads(RobotModel robot, std::span<const PartFault> faults) {
  for (const PartFault& fault : faults) {
    if (fault.kind != Kind::load) continue;
    const Vector3 p_BP(fault.place.x(), fault.place.y(), 0.0);
    add_load(robot.base, fault.value, robot.base.X_BL0.inverse() * p_BP);
  }
  return robot;
}

PartFaultPlant::PartFaultPlant(Plant& plant, std::vector<PartFault> faults, BodyAccess body,
                               double control_dt, double lead, std::uint64_t seed)
    : plant_(&plant), body_(std::move(body)), dt_(control_dt), lead_(lead), seed_(seed) {
  for (PartFault& fault : faults) add(std::move(fault));
}

void PartFaultPlant::add(PartFault fault) {
  const bool late = fault.kind == Kind::contact_late;
  const double periods = late ? std::round(fault.value / dt_) : 0.0;
  contacts_.emplace_back(static_cast<std::size_t>(periods) + 1);
  suffered_.push_back(false);
  faults_.push_back(std::move(fault));
}

// Half a period early: times of the walk are rounded to periods.
bool PartFaultPlant::begun(const PartFault& fault) const {
  return time() >= fault.start - 0.5 * dt_;
}

// Uniform in [0, 1).
double PartFaultPlant::draw(std::size_t fault, std::uint32_t more) const {
  constexpr std::uint64_t kMost = 8;
  return random_u01(seed_, RandomStream::sensors, kFirstTrial + static_cast<std::uint32_t>(fault),
                    periods_ * kMost + more);
}

PlantStatus PartFaultPlant::read(Measurement& measurement) {
  const PlantStatus status = plant_->read(measurement);
  if (status != PlantStatus::fresh) return status;
  for (std::size_t i = 0; i < faults_.size(); ++i) misread(i, measurement);
  return status;
}

void PartFaultPlant::misread(std::size_t index, Measurement& measurement) {
  const PartFault& fault = faults_[index];
  if (fault.leg < 0) return;
  bool& contact = measurement.contact[fault.leg];
  contacts_[index].push(contact ? 1 : 0);
  if (!begun(fault)) return;
  switch (fault.kind) {
    case Kind::contact_on:
      contact = true;
      break;
    case Kind::contact_off:
    case Kind::cut:
      contact = false;
      break;
    case Kind::contact_late:
      contact = contacts_[index].at(static_cast<std::size_t>(std::round(fault.value / dt_))) != 0;
      break;
    case Kind::contact_noise:
      if (draw(index, 0) < fault.value) contact = !contact;
      break;
    case Kind::noise:
      measurement.q[fault.leg][fault.joint] +=
          bell(fault.value, [&](int k) { return draw(index, static_cast<std::uint32_t>(k)); });
      break;
    case Kind::bias:
      measurement.q[fault.leg][fault.joint] += fault.value;
      break;
    default:
      break;
  }
}

void PartFaultPlant::write(const JointTargets& targets) {
  JointTargets sent = targets;
  for (const PartFault& fault : faults_) {
    if (!begun(fault)) continue;
    if (fault.kind == Kind::bias) sent.q[fault.leg][fault.joint] -= fault.value;
    if (fault.kind != Kind::dead && fault.kind != Kind::cut) continue;
    if (sent.mode.size() == 0) sent.mode = LegArray<ControlMode>(sent.q.size());
    sent.mode[fault.leg] = ControlMode::effort;
    sent.qd[fault.leg] = sent.effort[fault.leg].setZero();
  }
  suffer();
  ++periods_;
  plant_->write(sent);
}

void PartFaultPlant::suffer() {
  for (std::size_t i = 0; i < faults_.size(); ++i) {
    const PartFault& fault = faults_[i];
    if (suffered_[i] || !begun(fault)) continue;
    suffered_[i] = true;
    if (fault.kind == Kind::cut) body_.cut(fault.leg);
    if (fault.kind == Kind::weak) body_.weaken(fault.leg, fault.joint, fault.value);
    if (fault.kind == Kind::push)
      body_.push(fault.value / kPushTime * unit_vector(fault.direction), kPushTime);
  }
}

}  // namespace hexagait::walk
