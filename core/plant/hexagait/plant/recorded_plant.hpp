// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/plant/plant.hpp>
#include <span>
#include <vector>

namespace hexagait {

/// A plant that replays recorded measurements and records the targets written to it. The same
/// controller then computes the same targets, so a run on a robot can be examined at a desk.
class RecordedPlant final : public Plant {
 public:
  /// @param measurements  one per control period; must outlive the plant
  explicit RecordedPlant(std::span<const Measurement> measurements) : measurements_(measurements) {
    targets_.reserve(measurements.size() + 1);
  }

  /// The next measurement; `closed` after the last.
  PlantStatus read(Measurement& measurement) override {
    if (next_ == measurements_.size()) return PlantStatus::closed;
    measurement = measurements_[next_++];
    return PlantStatus::fresh;
  }

  void write(const JointTargets& targets) override { targets_.push_back(targets); }

  /// All that was written, in order.
  [[nodiscard]] const std::vector<JointTargets>& targets() const { return targets_; }

 private:
  std::span<const Measurement> measurements_;
  std::size_t next_ = 0;
  std::vector<JointTargets> targets_;
};

/// A robot whose joints are at their targets one period later, for previews. It has no ground: use
/// SensorMask::foot_contacts = false.
class PreviewPlant final : public Plant {
 public:
  /// @param q   joint positions at the start [rad]
  /// @param dt  control period [s]
  PreviewPlant(const LegArray<LegJoints>& q, double dt) : dt_(dt) {
    now_ = {0.0, q, LegArray<bool>(q.size(), true)};
  }

  PlantStatus read(Measurement& measurement) override {
    measurement = now_;
    now_.time += dt_;
    return PlantStatus::fresh;
  }

  void write(const JointTargets& targets) override { now_.q = targets.q; }

 private:
  double dt_;
  Measurement now_;
};

}  // namespace hexagait
