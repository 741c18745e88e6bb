// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/urdf/detail/leg_order.hpp>

namespace hexagait {
namespace {

constexpr double kOnMidline = 1e-4;  // [m]

bool has_equal_names(const LegArray<LegModel>& legs) {
  for (LegId i = 0; i < legs.size(); ++i)
    for (LegId j = 0; j < i; ++j)
      if (short_leg_name(legs[i].name) == short_leg_name(legs[j].name)) return true;
  return false;
}

std::string name_of_place(LegId leg, int num_legs) {
  const int pair = leg / 2, pairs = num_legs / 2;
  const std::string side = leg % 2 == 0 ? "L" : "R";
  if (pairs > 3) return side + std::to_string(pair + 1);
  return side + (pair == 0 ? "F" : pair + 1 == pairs ? "R" : "M");
}

}  // namespace

LegArray<LegModel> in_leg_order(std::vector<LegModel> legs, Violations& violations) {
  for (const LegModel& leg : legs)
    if (std::abs(leg.X_BH.p.y()) < kOnMidline)
      violations.add("leg " + leg.name, "hip is at y = " + in_words(leg.X_BH.p.y()) +
                                            " m; it must be left or right of the middle (--front)");
  std::stable_sort(legs.begin(), legs.end(), [](const LegModel& a, const LegModel& b) {
    return a.X_BH.p.x() > b.X_BH.p.x();
  });
  const auto right = std::stable_partition(
      legs.begin(), legs.end(), [](const LegModel& leg) { return leg.X_BH.p.y() > 0.0; });
  const auto num_left = right - legs.begin(), num_right = legs.end() - right;
  if (num_left != num_right) {
    violations.add("robot", "has " + std::to_string(num_left) + " legs on the left and " +
                                std::to_string(num_right) +
                                " on the right; need as many (--front, --legs)");
    return {};
  }
  LegArray<LegModel> ordered(static_cast<int>(legs.size()));
  for (int i = 0; i < ordered.size(); ++i)
    ordered[i] = std::move(legs[static_cast<std::size_t>(i / 2 + (i % 2 == 0 ? 0 : num_left))]);
  return ordered;
}

void make_names_unique(LegArray<LegModel>& legs, std::vector<Substitution>& substitutions) {
  if (!has_equal_names(legs)) return;
  for (LegId i = 0; i < legs.size(); ++i) {
    const std::string name = name_of_place(i, legs.size());
    substitutions.push_back({Origin::derived, "joint " + legs[i].joint_names[0], 0,
                             "name of the leg", legs[i].name, name + ", by its place", ""});
    legs[i].name = name;
  }
}

}  // namespace hexagait
