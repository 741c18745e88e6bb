// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [PC04] 5.2 and Fig. 12: on Lauron III the smooth displacement of the body is approximated by discrete
// ones. How far feet slip, by the duration of these.
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/pc04/fig12.gp.hpp>
#include <hexagait/pc04/pc04.hpp>
#include <hexagait/pc04/robot_judges.hpp>
#include <hexagait/pc04/snapshots.hpp>
#include <hexagait/recording/provenance.hpp>

namespace hexagait::experiments {
namespace {

using heading_control::Heading;
using heading_control::Turn;

constexpr double kServo = 0.05;                               // 20 Hz [s]
constexpr double kPeriods[] = {0.0, 0.02, kServo, 0.1, 0.2};  // 0: smooth [s]

struct Course {
  const char* name;
  Heading heading;
};
const Course kCourses[] = {{"ahead", Heading::straight(0.0)},
                           {"arc of 1 m", Heading::arc(1.0, 0.0)},
                           {"crab of 45°", Heading::straight(0.25 * std::numbers::pi)},
                           {"turn in place", Heading::spin(Turn::ccw)}};

// The walk that the experiment shows.
bool is_shown(const Course& course, double period) {
  return &course == kCourses && period == kServo;
}

// How far each foot gets from where it touched down, in each stance.
class FootSlips {
 public:
  FootSlips(const RobotModel& robot, double bounce)
      : bounce_(bounce), feet_(static_cast<std::size_t>(robot.num_legs())) {}

  void observe(const GroundTruth& truth) {
    for (LegId i = 0; i < truth.feet.size(); ++i) {
      Foot& foot = feet_[static_cast<std::size_t>(i)];
      const FootTruth& now = truth.feet[i];
      if (now.in_contact && !foot.stands) foot = {true, foot.before_touch, 0.0, truth.time};
      if (now.in_contact) {
        foot.farthest = std::max(foot.farthest, (now.slip - foot.before_touch).norm());
        foot.touched = truth.time;
      } else if (foot.stands && truth.time - foot.touched > bounce_) {
        slips_.push_back(foot.farthest);
        foot.stands = false;
      }
      if (!foot.stands) foot.before_touch = now.slip;
    }
  }
  [[nodiscard]] const std::vector<double>& slips() const { return slips_; }

 private:
  struct Foot {
    bool stands = false;
    Vector3 before_touch = Vector3::Zero();  // reading of its slip
    double farthest = 0.0;                   // [m]
    double touched = 0.0;                    // last [s]
  };
  double bounce_;
  std::vector<Foot> feet_;
  std::vector<double> slips_;
};

DisplacementWalk walked(const ExperimentContext& context, const RobotModel& robot,
                        const Course& course, double period) {
  recording::Simulation simulation;
  simulation.trial.schedule = {{0.0, course.heading}};
  simulation.trial.seconds = context.short_form ? 4.0 : 20.0;
  simulation.params.base.displacement_period = period;
  FootSlips slips(robot, params_for(robot).referee.bounce);
  const auto observe = [&](const auto&, const GroundTruth& truth, const auto&) {
    slips.observe(truth);
  };
  const walk::Summary summary = is_shown(course, period)
                                    ? simulate_shown(robot, simulation, observe, context)
                                    : recording::simulate(robot, simulation, observe, context.stop);
  return {course.name, period, summary, slips.slips()};
}

figures::Csv table_of(const std::vector<DisplacementWalk>& walks) {
  figures::Csv csv(
      "course,heading,period_ms,stances,slip_median_mm,slip_p95_mm,slip_most_mm,distance_m,turned_"
      "rad,"
      "off_path_mm");
  int course = 0;
  for (const DisplacementWalk& walk : walks) {
    const auto slip = [&](double share) { return 1e3 * walk::percentile(walk.slips, share); };
    if (!csv.rows().empty() && walk.period == 0.0) {
      csv.gap();
      ++course;
    }
    csv.row(course, walk.heading, 1e3 * walk.period, walk.slips.size(), slip(0.5), slip(0.95),
            slip(1.0), walk.summary.distance, walk.summary.turned, 1e3 * walk.summary.lateral_max);
  }
  return csv;
}

}  // namespace

Outcome fig12(const ExperimentContext& context, figures::StagedFiles& files) {
  const RobotModel lauron = context.robot_named("lauron");
  std::vector<DisplacementWalk> walks;
  std::vector<std::string> courses;
  const std::size_t all = std::size(kCourses) * std::size(kPeriods);
  for (const Course& course : kCourses) {
    courses.emplace_back(course.name);
    for (const double period : kPeriods) {
      walks.push_back(walked(context, lauron, course, period));
      if (context.stopped()) return {};
      context.tell(walks.size(), all);
    }
  }
  const figures::Csv table = table_of(walks);
  figures::write_tables(files, "fig12", {{"slips", table}});
  figures::draw_figure(
      files,
      context.figure("fig12", 1000, 640, "Slip of feet, by the duration of a displacement",
                     fmt::format("{} · flat ground · how far 95 % of the stances slip at most, and "
                                 "all (dashed) · 0: smooth · after [PC04] 5.2 and Fig. 12",
                                 lauron.name)),
      {{"courses", courses}, {"servo", 1e3 * kServo}}, scripts::pc04::fig12);
  return {.verdicts = judged_in_full_only(judge_fig12(walks, kServo), context.short_form),
          .settings = {{"robot", lauron.name},
                       {"terrain", "flat"},
                       {"walks", std::to_string(walks.size())},
                       {"servos", fmt::format("{:.0f} Hz", 1.0 / kServo)}},
          .provenance = recording::provenance(lauron.name, lauron, recording::Simulation{}),
          .table = table};
}

}  // namespace hexagait::experiments
