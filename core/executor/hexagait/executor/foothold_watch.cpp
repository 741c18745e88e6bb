// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/executor/foothold_watch.hpp>
#include <hexagait/executor/tick_motion.hpp>

namespace hexagait {

void FootholdWatch::watch(const LegArray<Vector3>& slide_O, LegSet stand, double dt,
                          const SwingParams& params) noexcept {
  giving_way_ = bad_ = {};
  if (slide_O.size() != ahead_O_.size()) return;
  // Exact for a foot that slides steadily within the tick.
  const double fallen = decay_share(dt / params.slide_time);
  const double of_new = fallen * params.slide_time / dt;
  for (LegId i = 0; i < ahead_O_.size(); ++i) {
    ahead_O_[i] += of_new * (slide_O[i] - before_O_[i]) - fallen * ahead_O_[i];
    before_O_[i] = slide_O[i];
    if (!stand.contains(i)) {
      ahead_O_[i].setZero();
      waited_[i] = 0.0;
    }
    if (ahead_O_[i].norm() <= params.slide_distance) continue;
    waited_[i] += dt;
    (waited_[i] <= params.slide_patience ? giving_way_ : bad_).insert(i);
  }
}

}  // namespace hexagait
