// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/fg16/foot_tracks.hpp>

namespace hexagait::experiments {
namespace {

constexpr long kEvery = 5;  // ticks from sample to sample

// Foothold to which a step sends a foot, in the map.
std::optional<Vector3> foothold_of(const action::Action& action, int step, LegId leg) {
  if (step < 1) return {};
  for (const action::LegCommand& command : action.steps[static_cast<std::size_t>(step) - 1].legs)
    if (const auto* footstep = std::get_if<action::Footstep>(&command.motion);
        footstep && footstep->leg == leg)
      return footstep->target.p;
  return {};
}

}  // namespace

void FootTracks::observe(const ActionRunner& runner, const Pose& X_OM, const GroundTruth& truth) {
  const ActionRecord& record = runner.record();
  if (ticks_ == 0) X_MO_start_ = truth.X_WB * record.state.X_OB.inverse();
  if (ticks_ == 0 || record.feedback.step != last_.step) X_MO_step_ = X_OM.inverse();
  const Sample now = sample(record, X_OM, truth);
  if (ticks_ > 0) {
    watch_landings(runner, now);
    watch_jumps(record, now);
  }
  commanded_O_ = now.commanded;
  for (LegId i = 0; i < record.legs.size(); ++i)
    commanded_O_[i] = record.state.X_OB * record.legs[i].p_BF;
  if (ticks_++ % kEvery == 0) samples_.push_back(now);
  last_ = now;
}

FootTracks::Sample FootTracks::sample(const ActionRecord& record, const Pose& X_OM,
                                      const GroundTruth& truth) const {
  const int n = record.legs.size();
  const Pose& X_OB = record.state.X_OB;
  const Pose X_MB = X_OM.inverse() * X_OB;
  const LegArray<Vector3> none(n);
  Sample now{truth.time, record.feedback.step, {}, none, none, none, none, truth.X_WB};
  for (LegId i = 0; i < n; ++i) {
    now.swinging.set(i, !record.legs[i].on_ground());
    now.commanded[i] = X_MO_step_ * (X_OB * record.legs[i].p_BF);
    now.reached[i] = truth.feet[i].p_WF;
    now.by_localisation[i] = X_MB * record.state.p_BF[i];
    now.by_odometry[i] = X_MO_start_ * (X_OB * record.state.p_BF[i]);
  }
  return now;
}

void FootTracks::watch_landings(const ActionRunner& runner, const Sample& now) {
  const action::Action& action = runner.sequencer().action();
  for (LegId i = 0; i < now.reached.size(); ++i) {
    if (!last_.swinging.contains(i) || now.swinging.contains(i)) continue;
    if (const auto foothold = foothold_of(action, last_.step, i))
      touchdowns_.push_back({now.time, i, *foothold, now.reached[i]});
  }
}

void FootTracks::watch_jumps(const ActionRecord& record, const Sample& now) {
  const double dt = now.time - last_.time;
  for (LegId i = 0; i < record.legs.size(); ++i) {
    const Vector3 commanded_O = record.state.X_OB * record.legs[i].p_BF;
    const Vector3 way_O = dt * record.legs[i].v_O;
    const Vector3 localised = now.by_localisation[i] - last_.by_localisation[i];
    commanded_jump_ = std::max(commanded_jump_, (commanded_O - commanded_O_[i] - way_O).norm());
    localised_jump_ = std::max(localised_jump_, (localised - X_MO_step_.R * way_O).norm());
  }
}

std::vector<double> FootTracks::swing_errors() const {
  std::vector<double> errors;
  for (const Sample& sample : samples_)
    for (LegId i = 0; i < sample.reached.size(); ++i)
      if (sample.swinging.contains(i))
        errors.push_back((sample.commanded[i] - sample.reached[i]).norm());
  return errors;
}

}  // namespace hexagait::experiments
