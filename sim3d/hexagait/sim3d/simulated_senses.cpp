// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <hexagait/sim3d/simulated_senses.hpp>

namespace hexagait::sim3d {
namespace {

// Of mean 0 and deviation 1: the sum of four uniform numbers, each of deviation 1/√12.
double bell(RandomSequence& random) {
  double sum = 0.0;
  for (int i = 0; i < 4; ++i) sum += random.uniform(-1.0, 1.0);
  return std::sqrt(0.75) * sum;
}

bool bends(const World& world, const navigation::Whisker& whisker, const Pose& X_WB) {
  const Vector3 way = whisker.tip_B - whisker.root_B;
  const double length = way.norm();
  return std::isfinite(world.range(X_WB * whisker.root_B, X_WB.R * (way / length), length));
}

}  // namespace

PlantStatus Inclinometer::read(Measurement& measurement) {
  const PlantStatus status = plant_->read(measurement);
  if (status != PlantStatus::fresh) return status;
  measurement.inclination.pitch = roll_pitch_yaw(world_->truth().X_WB.R).y();
  if (noise_ > 0.0) measurement.inclination.pitch += noise_ * bell(draws_);
  return status;
}

navigation::Senses sense(const World& world, const navigation::SenseLayout& layout, double noise,
                         RandomSequence& noise_draws) {
  const Pose& X_WB = world.truth().X_WB;
  navigation::Senses senses;
  for (std::size_t k = 0; k < navigation::kWhiskers; ++k)
    senses.touches[k] = bends(world, layout.whiskers[k], X_WB);
  for (std::size_t k = 0; k < navigation::kBeams; ++k) {
    const navigation::Beam& beam = layout.beams[k];
    senses.range[k] = world.range(X_WB * beam.from_B, X_WB.R * beam.direction_B, beam.longest());
    if (noise > 0.0) senses.range[k] *= 1.0 + noise * bell(noise_draws);
  }
  return senses;
}

}  // namespace hexagait::sim3d
