// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/verify/detail/situation.hpp>
#include <hexagait/verify/detail/theorems.hpp>
#include <map>
#include <set>

namespace hexagait::verify {

using namespace gait_state;

namespace {

constexpr const char* kTypes = "-ABCD";

/// Representative of a class up to rotation: the smallest of the rotated bit patterns.
RingBits rotation_class(const GaitState& state) {
  RingBits smallest = state.bits, turned = state.bits;
  for (int k = 0; k < state.n; ++k) {
    turned = from_before(turned, state.n);
    smallest = std::min(smallest, turned);
  }
  return smallest;
}

struct TableCell {
  int states = 0;
  std::set<RingBits> classes;
  std::string first;
};

}  // namespace

Theorem states(const Rules&, const Scope&) {
  Theorem theorem;
  theorem.name = "states";
  theorem.statement =
      "Six legs have 62 gait states, in 12 cells by CCN and type; up to rotation each cell is one "
      "state ([PC04] Table 1).";
  theorem.convention =
      "a < b: b steps first. CCN: how many relations are <. A: one leg may step; B: two that share "
      "a neighbour; C: two that do not; D: three. CCN 0 and 6 are cyclic and no states.";
  theorem.table.columns = {"CCN", "type", "states", "classes", "example"};

  std::map<std::pair<int, GaitType>, TableCell> cells;
  for (const GaitState& state : non_cyclic_states(6)) {
    TableCell& cell = cells[{state.ccn(), type_of(state)}];
    if (cell.first.empty()) cell.first = to_string(state);
    ++cell.states;
    cell.classes.insert(rotation_class(state));
    theorem.check(type_of(state) != GaitType::none,
                  [&] { return to_string(state).append(" is of no type"); });
    ++theorem.cases;
  }
  for (const auto& [key, cell] : cells) {
    const int ccn = key.first;
    const std::string type(1, kTypes[static_cast<std::size_t>(key.second)]);
    const auto classes = static_cast<std::int64_t>(cell.classes.size());
    theorem.table.add(ccn, type, cell.states, classes, cell.first);
    theorem.check(classes == 1, [&] {
      return fmt::format("{} classes of CCN {} and type {}", classes, ccn, type);
    });
  }
  theorem.check(cells.size() == 12 && theorem.cases == 62,
                [] { return "there are other cells, or more"; });
  return theorem;
}

Theorem adjustment(const Rules& rules, const Scope& scope) {
  Theorem theorem;
  theorem.name = "adjustment";
  theorem.statement =
      "The CCN adjustment (gait 2) leads from every state to CCN = n/2 and keeps every < > pair.";
  theorem.convention =
      "Every state that is not cyclic; so the legs that may step, and the type, stay the same. "
      "Most turned: relations that it had to turn.";
  theorem.table.columns = {"legs", "states", "already_balanced", "most_turned"};
  for (const int n : scope.legs) {
    int balanced = 0, most = 0;
    for (const GaitState& state : non_cyclic_states(n)) {
      const GaitState result = rules.adjusted(state, n / 2);
      const auto words = [&] {
        return fmt::format("{} becomes {}", to_string(state), to_string(result));
      };
      theorem.check(result.n == n && result.ccn() == n / 2, words);
      theorem.check(priority_legs(result) == priority_legs(state), words);
      balanced += state.ccn() == n / 2 ? 1 : 0;
      most = std::max(most, std::popcount(state.bits ^ result.bits));
      ++theorem.cases;
    }
    theorem.table.add(n, (1 << n) - 2, balanced, most);
  }
  return theorem;
}

}  // namespace hexagait::verify
