// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <hexagait/walk/referee/path_judge.hpp>
#include <limits>

namespace hexagait::walk {
namespace {

constexpr double kAtStart = 0.25;  // of the look-ahead
constexpr double kSpacing = 0.05;  // of the look-ahead, between points that are to be visited
constexpr double kWindow = 2.0;    // of the look-ahead, in which a place is looked for
constexpr double kMostSamples = 1e5;

}  // namespace

PathJudge::PathJudge(const path_following::PathTask& task, const PlanarPose& start)
    : task_(&task), start_(start) {
  spacing_ = std::max(kSpacing * task.look_ahead, task.end() / kMostSamples);
  const auto points = static_cast<std::size_t>(std::floor(task.end() / spacing_)) + 1;
  nearest_.assign(points, std::numeric_limits<double>::infinity());
}

double PathJudge::follow(Progress& progress, const Vector2& p_P) const {
  const path_following::Path& path = task_->path;
  const Vector2 to_first = path.at(0.0) - p_P;
  progress.on_path |= to_first.norm() <= kAtStart * task_->look_ahead;
  if (!progress.on_path) return to_first.norm();
  const double window = kWindow * task_->look_ahead;
  progress.s = path.nearest(p_P, std::max(0.0, progress.s - window),
                            std::min(task_->end(), progress.s + window));
  const Vector2 off = p_P - path.at(progress.s);
  const double left = cross(unit_vector(path.direction(progress.s)), off);
  return std::copysign(off.norm(), left);
}

// Points near enough in order: where the path crosses itself, the others are visited at another time.
void PathJudge::visit(const Vector2& p_P) {
  const double window = kWindow * task_->look_ahead;
  const auto last = static_cast<double>(nearest_.size() - 1);
  const auto from = static_cast<std::size_t>(std::max(0.0, (progress_.s - window) / spacing_));
  const auto to = static_cast<std::size_t>(std::min(last, (progress_.s + window) / spacing_));
  for (std::size_t k = from; k <= to; ++k)
    nearest_[k] = std::min(nearest_[k],
                           (task_->path.at(static_cast<double>(k) * spacing_) - p_P).squaredNorm());
}

ReferencePath::Deviation PathJudge::observe(const PlanarPose& X_WB, const PlanarPose& X_OB) {
  const PlanarPose X_PB = between(start_, X_WB);
  const double lateral = follow(progress_, X_PB.shift);
  const double believed = std::abs(follow(believed_, X_OB.shift));
  if (believed_.on_path) {
    ++believed_ticks_;
    believed_sum_ += believed;
    believed_max_ = std::max(believed_max_, believed);
  }
  off_end_ = (task_->path.at(task_->end()) - X_PB.shift).norm();
  const double turned = wrap_angle(X_PB.angle);
  if (!progress_.on_path) return {0.0, 0.0, -lateral, turned};
  visit(X_PB.shift);
  return {lateral, wrap_angle(X_PB.angle - facing_at(*task_, progress_.s)), progress_.s, turned};
}

PlanarPose PathJudge::ideal() const {
  return start_ * PlanarPose{facing_at(*task_, progress_.s), task_->path.at(progress_.s)};
}

PathSummary PathJudge::summary() const {
  PathSummary summary;
  summary.length = task_->end();
  summary.done = progress_.s;
  if (believed_ticks_ > 0)
    summary.believed_mean = believed_sum_ / static_cast<double>(believed_ticks_);
  summary.believed_max = believed_max_;
  const auto visited =
      std::min(nearest_.size(), static_cast<std::size_t>(progress_.s / spacing_) + 1);
  for (std::size_t k = 0; progress_.on_path && k < visited; ++k)
    summary.missed = std::max(summary.missed, std::sqrt(nearest_[k]));
  summary.off_end = off_end_;
  return summary;
}

}  // namespace hexagait::walk
