// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <hexagait/path_following/path_faults.hpp>
#include <hexagait/text/violations.hpp>
#include <set>

namespace hexagait::path_following {
namespace {

constexpr double kOnePlace = 1e-6;  // of the stride
constexpr double kDegrees = 180.0 / std::numbers::pi;

std::string degrees(double angle) { return in_words(std::round(kDegrees * angle)) + "°"; }

// "point 3, (1, 0)", counted from 1.
std::string name_of(const std::vector<Waypoint>& waypoints, std::size_t k) {
  const Vector2& p = waypoints[k].p_P;
  return "point " + std::to_string(k + 1) + ", (" + in_words(p.x()) + ", " + in_words(p.y()) + ")";
}

void find_no_numbers(std::vector<PathFault>& faults, const std::vector<Waypoint>& waypoints) {
  for (std::size_t k = 0; k < waypoints.size(); ++k) {
    const Waypoint& point = waypoints[k];
    if (!point.p_P.allFinite())
      faults.push_back({k, name_of(waypoints, k) + ", is no place; x and y must be finite"});
    if (point.facing && !std::isfinite(*point.facing))
      faults.push_back({k, name_of(waypoints, k) + ": its facing is no angle; it must be finite"});
    if (!(point.speed > 0.0))
      faults.push_back({k, name_of(waypoints, k) + ": its speed is " + in_words(point.speed) +
                               "; it must be more than 0"});
  }
}

void find_coincident(std::vector<PathFault>& faults, const std::vector<Waypoint>& waypoints,
                     bool closed, double stride) {
  const std::size_t n = waypoints.size();
  for (std::size_t k = 1; k < n; ++k)
    if (!((waypoints[k].p_P - waypoints[k - 1].p_P).norm() > kOnePlace * stride))
      faults.push_back(
          {k, name_of(waypoints, k) + ", is where the one before is; points in a row must differ"});
  if (closed && !((waypoints[n - 1].p_P - waypoints[0].p_P).norm() > kOnePlace * stride))
    faults.push_back(
        {n - 1, name_of(waypoints, n - 1) +
                    ", is where the first is; a closed path goes on to the first point by "
                    "itself: leave the last one out"});
}

// The direction at the beginning and end of each piece, unwrapped, over two laps of a closed path.
struct Bend {
  double s, direction;
  std::size_t waypoint;
};
std::vector<Bend> bends_of(const Path& path) {
  std::vector<Bend> bends;
  double direction = 0.0;
  for (int lap = 0; lap < (path.closed() ? 2 : 1); ++lap) {
    for (std::size_t k = 0; k < path.pieces().size(); ++k) {
      const Path::Piece& piece = path.pieces()[k];
      const double before = lap * path.length();
      direction += bends.empty() ? piece.direction : wrap_angle(piece.direction - direction);
      bends.push_back({before + piece.s, direction, piece.waypoint});
      direction += piece.turn;
      bends.push_back({before + path.end_of(k), direction, piece.waypoint});
    }
  }
  return bends;
}

// Where directions less than a stride apart differ by too much. The greatest and least direction within
// the last stride tell; after a fault the next one is looked for beyond it.
void find_doubling_back(std::vector<PathFault>& faults, const std::vector<Waypoint>& waypoints,
                        const Path& path, double stride) {
  const std::vector<Bend> bends = bends_of(path);
  std::multiset<double> within;
  std::vector<bool> told(waypoints.size(), false);
  std::size_t first = 0;
  for (std::size_t k = 0; k < bends.size(); ++k) {
    while (bends[first].s < bends[k].s - stride)
      within.erase(within.find(bends[first++].direction));
    within.insert(bends[k].direction);
    const double turn = *within.rbegin() - *within.begin();
    const std::size_t waypoint = bends[k].waypoint;
    if (turn < kMostTurn) continue;
    if (!told[waypoint])
      faults.push_back(
          {waypoint,
           name_of(waypoints, waypoint) + ": the path turns by " + degrees(turn) + " within " +
               in_words(stride, 3) +
               " m, the stride of this robot: it doubles back; it must turn by less than " +
               degrees(kMostTurn) + " there: move the points apart, or leave some out"});
    told[waypoint] = true;
    within = {bends[k].direction};
    first = k;
  }
}

}  // namespace

std::vector<PathFault> faults_of(const std::vector<Waypoint>& waypoints, Shape shape, bool closed,
                                 double stride) {
  const std::size_t least = closed ? 3 : 2, n = waypoints.size();
  if (n < least)
    return {{n == 0 ? 0 : n - 1, "has " + std::to_string(n) + (n == 1 ? " point; " : " points; ") +
                                     (closed ? "a closed path" : "a path") +
                                     " must have at least " + std::to_string(least)}};
  std::vector<PathFault> faults;
  find_no_numbers(faults, waypoints);
  if (faults.empty()) find_coincident(faults, waypoints, closed, stride);
  if (faults.empty()) find_doubling_back(faults, waypoints, Path(waypoints, shape, closed), stride);
  return faults;
}

}  // namespace hexagait::path_following
