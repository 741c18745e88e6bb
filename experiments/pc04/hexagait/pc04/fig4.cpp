// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] Fig. 4: the possible transitions between gait states with CCN = 3, as legs that have
// priority step, alone or together. Left modulo rotations of the ring, right all 20 states.
#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <hexagait/figures/csv.hpp>
#include <hexagait/figures/drawing.hpp>
#include <hexagait/pc04/gait_tables.hpp>
#include <hexagait/pc04/judges.hpp>
#include <hexagait/pc04/pc04.hpp>
#include <map>
#include <numbers>
#include <set>

namespace hexagait::experiments {
namespace {

using gait_state::GaitState;

// By the number of legs that step together.
constexpr std::array<const char*, 4> kColour = {"", "left_side", "right_side", "accent"};

std::vector<Transition> transitions() {
  std::vector<Transition> all;
  for (gait_state::RingBits bits = 0; bits <= gait_state::ring_mask(kLegs); ++bits) {
    const GaitState from{bits, kLegs};
    if (from.ccn() != kLegs / 2) continue;
    const std::uint32_t priority = priority_legs(from).bits();
    // All non-empty subsets of the legs with priority.
    for (std::uint32_t subset = priority; subset != 0; subset = (subset - 1) & priority) {
      GaitState to = from;
      for (LegId leg = 0; leg < kLegs; ++leg)
        if (LegSet(subset).contains(leg)) to = after_step(to, leg);
      all.push_back({from, to, LegSet(subset)});
    }
  }
  return all;
}

char letter(const GaitState& state) { return letter_of(type_of(state)); }

// By how many places the state is the least of its rotations, rotated clockwise.
int rotation_of(const GaitState& state) {
  std::string text = least_rotation(to_string(state));
  int turn = 0;
  for (; text != to_string(state); ++turn) std::rotate(text.begin(), text.end() - 1, text.end());
  return turn;
}

// A curve from one disc to another, bulging to the right by a share of its length.
std::vector<Vector2> curve(const Vector2& from, const Vector2& to, double bulge, double radius) {
  const Vector2 way = to - from;
  const Vector2 control = 0.5 * (from + to) + 2.0 * bulge * Vector2(-way.y(), way.x());
  std::vector<Vector2> points;
  for (int k = 0; k <= 60; ++k) {
    const double t = k / 60.0;
    const Vector2 p = (1 - t) * (1 - t) * from + 2 * t * (1 - t) * control + t * t * to;
    if ((p - from).norm() > radius && (p - to).norm() > radius + 2.0) points.push_back(p);
  }
  return points;
}

void label(figures::Drawing& drawing, const Vector2& place, int legs, double points) {
  drawing.disc(place, 0.72 * points, figures::kWhite, figures::kWhite);
  drawing.text(place, std::to_string(legs),
               {.points = points, .colour = kColour[static_cast<std::size_t>(legs)], .bold = true});
}

void node(figures::Drawing& drawing, const Vector2& place, double radius, char type,
          const std::string& state) {
  drawing.disc(place, radius, figures::type_shade(type), figures::kInk);
  const char* const ink = type == 'D' ? figures::kWhite : figures::kInk;
  const double shift = state.empty() ? 0.0 : 6.0;
  drawing.text(place - Vector2(0.0, shift), std::string(1, type),
               {.points = 0.45 * radius, .colour = ink, .bold = true});
  if (!state.empty())
    drawing.text(place + Vector2(0.0, 0.42 * radius), state,
                 {.points = 7.5, .colour = ink, .mono = true});
}

// Left: four types.
void draw_types(figures::Drawing& drawing, const std::vector<Transition>& all) {
  const std::map<char, Vector2> places = {
      {'A', {90.0, 430.0}}, {'B', {265.0, 265.0}}, {'C', {265.0, 595.0}}, {'D', {440.0, 430.0}}};
  constexpr double kRadius = 34.0;
  std::set<std::tuple<char, char, int>> edges;
  for (const Transition& t : all) edges.emplace(letter(t.from), letter(t.to), t.legs.size());
  for (const auto& [from, to, legs] : edges) {
    const char* const colour = kColour[static_cast<std::size_t>(legs)];
    const Vector2 &a = places.at(from), &b = places.at(to);
    if (from == to) {  // D steps with all three: a loop
      std::vector<Vector2> loop;
      for (int k = 0; k <= 48; ++k) {
        const double angle = -2.45 + 4.9 * k / 48.0;
        loop.push_back(a + Vector2(56.0, 0.0) + 33.0 * unit_vector(angle));
      }
      drawing.arrow(loop, colour, 2.0);
      label(drawing, a + Vector2(89.0, 0.0), legs, 13.0);
      continue;
    }
    const std::vector<Vector2> points = curve(a, b, 0.10, kRadius);
    drawing.arrow(points, colour, 2.0);
    label(drawing, points[points.size() / 2], legs, 13.0);
  }
  for (const auto& [type, place] : places) node(drawing, place, kRadius, type, "");
}

// Right: six spokes; on spoke j the states A, B, C whose rotation belongs there, in the middle D.
Vector2 place_of(const GaitState& state) {
  const Vector2 centre(960.0, 470.0);
  const char type = letter(state);
  const int rotation = rotation_of(state);
  if (type == 'D') return centre + Vector2(rotation == 0 ? -52.0 : 52.0, 0.0);
  const double radius = type == 'A' ? 372.0 : type == 'B' ? 178.0 : 278.0;
  const double spoke = type == 'C' ? rotation - 1 : rotation;
  const double angle = std::numbers::pi / 3.0 * spoke - std::numbers::pi / 2.0;
  return centre + radius * unit_vector(angle);
}

double bulge_of(const Transition& t) {
  const char from = letter(t.from), to = letter(t.to);
  if (from == 'A') return 0.32;               // to B, round C
  if (from == 'D' && to == 'D') return 0.18;  // there and back
  if (from == 'B' && to == 'C') return 0.06;
  if (from == 'C' && to == 'D') return 0.24;  // round B
  if (from == 'D' && to == 'C') return 0.24;
  return 0.0;
}

void draw_states(figures::Drawing& drawing, const std::vector<Transition>& all) {
  constexpr double kRadius = 26.0;
  for (const Transition& t : all)
    drawing.arrow(curve(place_of(t.from), place_of(t.to), bulge_of(t), kRadius),
                  kColour[static_cast<std::size_t>(t.legs.size())], 1.3);
  for (std::size_t k = 0; k < all.size(); ++k)
    if (k == 0 || all[k].from != all[k - 1].from)
      node(drawing, place_of(all[k].from), kRadius, letter(all[k].from), to_string(all[k].from));
}

figures::Drawing drawn(const std::vector<Transition>& all) {
  figures::Drawing drawing;
  const Vector2 legend(62.0, 780.0);
  for (int legs = 1; legs <= 3; ++legs) {
    const Vector2 row = legend + Vector2(0.0, 26.0 * (legs - 1));
    const auto i = static_cast<std::size_t>(legs);
    drawing.arrow({row, row + Vector2(40.0, 0.0)}, kColour[i], 2.0);
    drawing.text(row + Vector2(52.0, 0.0),
                 fmt::format("{} {}", legs, legs == 1 ? "leg steps" : "legs step"),
                 {.points = 10.5, .align = "left"});
  }
  drawing.text({50.0, 118.0}, "a   Modulo rotations of the ring",
               {.points = 11.0, .align = "left", .bold = true});
  std::set<std::string> states;
  for (const Transition& t : all) states.insert(to_string(t.from));
  drawing.text({560.0, 118.0}, fmt::format("b   All {} states", states.size()),
               {.points = 11.0, .align = "left", .bold = true});
  draw_types(drawing, all);
  draw_states(drawing, all);
  return drawing;
}

}  // namespace

Outcome fig4(const ExperimentContext& context, figures::StagedFiles& files) {
  const std::vector<Transition> all = transitions();
  figures::Csv table("from,from_type,to,to_type,legs");
  for (const Transition& t : all)
    table.row(to_string(t.from), letter(t.from), to_string(t.to), letter(t.to), t.legs.size());
  files.write("fig4.csv", table.text());
  drawn(all).draw(
      files, context.figure("fig4", 1400, 890, "Transitions between the gait states with CCN = 3",
                            "an arrow for each set of legs with priority that step together · "
                            "letters: type of state · after [PC04] Fig. 4"));
  return {.verdicts = judge_fig4(all), .settings = {{"legs", "6"}, {"ccn", "3"}}};
}

}  // namespace hexagait::experiments
