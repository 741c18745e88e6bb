// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <hexagait/gait_state/latch.hpp>
#include <hexagait/sim/random.hpp>
#include <vector>

// The latch against a second implementation that goes edge by edge and leg by leg, in words.
namespace hexagait::gait_state {
namespace {

constexpr double kTolerance = 1e-3;

// One relation, seen from the leg `a` before and the leg `b` after it on the ring.
struct EdgeMemory {
  bool stored_less = false;
  bool raw_less = false;
  bool both_stood = false;
};

bool decided_afresh(const GaitInput& in, LegId a, LegId b, int n) {
  if (in.airborne.contains(a) != in.airborne.contains(b)) return in.airborne.contains(b);
  if (std::abs(in.lag[a] - in.lag[b]) <= kTolerance) return first_tripod(n).contains(b);
  return in.lag[a] < in.lag[b];
}

bool decided_now(const GaitInput& in, LegId a, LegId b, const EdgeMemory& memory, int n) {
  if (in.airborne.contains(a) && in.airborne.contains(b)) return memory.raw_less;
  const bool both_stand = !in.airborne.contains(a) && !in.airborne.contains(b);
  if (!both_stand || !memory.both_stood) return decided_afresh(in, a, b, n);
  const double for_a = in.lag[a] - in.lag[b];
  const bool contradicted = memory.raw_less ? for_a > kTolerance : -for_a > kTolerance;
  return contradicted ? !memory.raw_less : memory.raw_less;
}

class EdgeByEdge {
 public:
  GaitState update(const GaitInput& in) {
    const int n = in.lag.size();
    const bool first = edges_.empty();
    edges_.resize(static_cast<std::size_t>(n));
    for (int k = 0; k < n; ++k)
      update_edge(in, leg_at(k, n), leg_at((k + 1) % n, n), edge(k), first);
    if (state().is_cyclic()) {
      for (int k = 0; k < n; ++k) {
        edge(k).raw_less = decided_afresh(in, leg_at(k, n), leg_at((k + 1) % n, n), n);
        edge(k).stored_less = edge(k).raw_less;
      }
    }
    const GaitState result = adjusted(state(), n / 2);
    for (int k = 0; k < n; ++k) edge(k).stored_less = ((result.bits >> k) & 1U) != 0;
    return result;
  }

 private:
  EdgeMemory& edge(int k) { return edges_[static_cast<std::size_t>(k)]; }

  static void update_edge(const GaitInput& in, LegId a, LegId b, EdgeMemory& edge, bool first) {
    const bool less = first ? decided_afresh(in, a, b, in.lag.size())
                            : decided_now(in, a, b, edge, in.lag.size());
    const bool urgent = in.urgent.contains(a) || in.urgent.contains(b);
    if (first || less != edge.raw_less || urgent) edge.stored_less = less;
    edge.raw_less = less;
    edge.both_stood = !in.airborne.contains(a) && !in.airborne.contains(b);
  }

  GaitState state() {
    GaitState result{0, static_cast<int>(edges_.size())};
    for (int k = 0; k < result.n; ++k) {
      if (edge(k).stored_less) result.bits |= 1U << k;
    }
    return result;
  }

  std::vector<EdgeMemory> edges_;
};

// A random history: lags drift, jump and tie, legs lift, land and fail, some become urgent.
void evolve(GaitInput& in, RandomSequence& random) {
  for (LegId leg = 0; leg < in.lag.size(); ++leg) {
    in.lag[leg] += random.uniform(-0.4, 0.4) * kTolerance;
    if (random.u01() < 0.05) in.lag[leg] = kTolerance * std::floor(random.uniform(0.0, 6.0));
    if (random.u01() < 0.1) in.airborne.set(leg, random.u01() < 0.4);
    in.urgent.set(leg, random.u01() < 0.02);
  }
}

TEST(Latch, AgreesWithAnEdgeByEdgeImplementation) {
  int cyclic = 0;
  for (std::uint32_t trial = 0; trial < 500; ++trial) {
    const int n = 4 + 2 * static_cast<int>(trial % 5);
    RandomSequence random{.seed = 21, .trial = trial};
    GaitInput in{LegArray<double>(n), {}, {}};
    GaitLatch latch;
    EdgeByEdge oracle;
    for (int i = 0; i < 200; ++i) {
      evolve(in, random);
      const GaitDecision decision = latch.update(in, {.tie_tolerance = kTolerance});
      ASSERT_EQ(decision.state, oracle.update(in)) << "trial " << trial << ", update " << i;
      ASSERT_FALSE(decision.state.is_cyclic());
      cyclic += decision.was_cyclic ? 1 : 0;
    }
  }
  EXPECT_GT(cyclic, 0) << "the histories must meet the cyclic case";
}

// The trap once more, for any history: an adjustment that is forgotten moves no `< >` pair either.
TEST(Modes, LiteralLetsTheSameLegsStepAsNoneInEveryHistory) {
  for (std::uint32_t trial = 0; trial < 200; ++trial) {
    const int n = 4 + 2 * static_cast<int>(trial % 5);
    RandomSequence random{.seed = 22, .trial = trial};
    GaitInput in{LegArray<double>(n), {}, {}};
    GaitLatch literal, none;
    for (int i = 0; i < 200; ++i) {
      evolve(in, random);
      ASSERT_EQ(
          literal.update(in, {.tie_tolerance = kTolerance, .adjustment = Adjustment::literal})
              .may_step,
          none.update(in, {.tie_tolerance = kTolerance, .adjustment = Adjustment::none}).may_step);
    }
  }
}

}  // namespace
}  // namespace hexagait::gait_state
