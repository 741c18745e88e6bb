// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [FG16] Fig. 7: footholds in the map, a localisation that jumps, and odometry that drifts. Free
// Gait takes each motion from the map to odom when it starts: smooth and accurate.
#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <hexagait/fg16/fg16.hpp>
#include <hexagait/fg16/foot_tracks.hpp>
#include <hexagait/fg16/foothold_route.hpp>
#include <hexagait/fg16/judges.hpp>
#include <hexagait/fg16/localisation.hpp>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/walk/action_trial.hpp>

namespace hexagait::experiments {
namespace {

constexpr const char* kTerrain = "step:0.12";
const Route kRoute = {.start = -1.8};  // 2.4 m on the level, then up the step
constexpr double kYawError = 0.0175;   // of the joints' zeros, 1°: drifts by 5 cm over 3 m [rad]
constexpr std::uint64_t kSeed = 1;
constexpr LegId kShown = 0;     // LF
constexpr double kZoom = 20.0;  // of its track, from here on [s]

struct Walk {
  walk::ActionSummary summary;
  FootTracks tracks;
};

enum class Map { combined, odometry_only };

// Odometry only: the localisation says where the robot starts, and then nothing more.
Walk walk(Map map, const ExperimentContext& context) {
  const RobotModel& robot = *context.robot;
  const sim3d::TerrainSpec terrain = sim3d::parse_terrain(kTerrain);
  sim3d::WorldParams params;
  params.start.shift = {kRoute.start, 0.0};
  sim3d::World world(robot, terrain, params, walk::nominal_posture(robot));
  MiscalibratedPlant plant(world, kYawError);

  Walk walk;
  ActionRunner runner(robot);
  JumpingLocalisation localisation({.seed = kSeed});
  std::optional<Pose> X_OM_start;
  walk::ActionTrialOptions options;
  options.localisation = [&](const ActionRecord& record, const GroundTruth& truth) {
    if (!X_OM_start) X_OM_start = record.state.X_OB * truth.X_WB.inverse();
    return map == Map::combined ? localisation.X_OM(record, truth) : *X_OM_start;
  };
  const auto observe = [&](const ActionRecord&, const GroundTruth& truth) {
    walk.tracks.observe(runner, runner.frames().X_OM, truth);
    return context.stop == nullptr || !context.stop->load();
  };
  const auto footholds = footholds_along(kRoute, robot, world.terrain());
  const action::Action action = walk_on(footholds, "walk in the map");
  walk.summary = walk::run_action(runner, plant, world.truth(), action, options, observe);
  return walk;
}

// How far the base is when this foothold is the foot's place under it [m].
double way(const FootTracks::Touchdown& t, const RobotModel& robot) {
  return t.foothold.x() - robot.legs[t.leg].p_BC.x() - kRoute.start;
}

// The foot that is shown, in three frames.
void write_foot(std::ostream& out, const FootTracks& tracks) {
  out << "time_s,localised_x_m,localised_y_m,localised_z_m,odometry_x_m,odometry_y_m,odometry_z_m,"
         "x_m,y_m,z_m\n";
  for (const FootTracks::Sample& s : tracks.samples()) {
    const Vector3 &l = s.by_localisation[kShown], &o = s.by_odometry[kShown],
                  &p = s.reached[kShown];
    fmt::print(out, "{:.2f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f}\n",
               s.time, l.x(), l.y(), l.z(), o.x(), o.y(), o.z(), p.x(), p.y(), p.z());
  }
}

void write_touchdowns(std::ostream& out, const Walk& combined, const Walk& odometry,
                      const RobotModel& robot) {
  out << "odometry_only,leg,way_m,foothold_x_m,foothold_y_m,foothold_z_m,x_m,y_m,z_m,error_m\n";
  for (const Walk* walk : {&combined, &odometry})
    for (const FootTracks::Touchdown& t : walk->tracks.touchdowns())
      fmt::print(out, "{},{},{:.4f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f}\n",
                 walk == &odometry ? 1 : 0, t.leg, way(t, robot), t.foothold.x(), t.foothold.y(),
                 t.foothold.z(), t.reached.x(), t.reached.y(), t.reached.z(), t.error());
}

constexpr const char* kScript = R"(
set multiplot
set label 1 headline at screen 0.05, 0.96 left noenhanced font sized("", 15) textcolor rgb ink
set label 2 subtitle at screen 0.05, 0.92 left noenhanced font sized("", 10.5) textcolor rgb grey
small = sized("", 9)
localised = accent; by_odometry = right_side; combined = left_side

# a: the left front foot from above, its sideways motion drawn larger than its way
set lmargin at screen 0.05; set rmargin at screen 0.985
set bmargin at screen 0.57; set tmargin at screen 0.83
set label 3 "{/:Bold a}   The left front foot from above: sideways over the way [m], 4 times as large" \
    at graph 0, graph 1 offset 0, 0.9 left textcolor rgb ink
set xrange [-1.36:1.76]; set yrange [y_min:y_min + 3.12*0.26*height/(4*0.935*width)]
set xtics 0.5; set ytics 0.05
set key at graph 1, graph 1.03 right bottom horizontal samplen 1.6 width -2 font small
set object 1 rectangle from 0.6, graph 0 to graph 1, graph 1 fs solid 0.25 noborder fc rgb earth behind
set label 4 "up the step" at 0.62, graph 0.06 left textcolor rgb ink font small
plot "fg16_fig7-foot.csv" using 2:3 with lines lw 1.2 lc rgb localised title "by localisation", \
     "fg16_fig7-foot.csv" using 5:6 with lines lw 1.6 lc rgb by_odometry title "by odometry", \
     "fg16_fig7-touchdowns.csv" using ($1 == 0 && $2 == 0 ? $4 : NaN):5 with points pt 6 ps 1.6 lw 2 \
         lc rgb ink title "footholds in the map", \
     "fg16_fig7-foot.csv" using 8:9 with lines lw 2 lc rgb combined title "combined, as executed"
unset label 1; unset label 2; unset label 4; unset object 1

# b: some seconds of it
set rmargin at screen 0.475; set bmargin at screen 0.085; set tmargin at screen 0.455
set label 3 "{/:Bold b}   Five seconds: sideways [m] over time [s]" at graph 0, graph 1 offset 0, 0.9 \
    left textcolor rgb ink
set xrange [zoom:zoom+5]; set yrange [y_min+0.01:y_min+0.13]
set xtics 1; set ytics 0.02
set xlabel "time [s]" offset 0, 0.5
unset key
plot "fg16_fig7-foot.csv" using 1:3 with lines lw 1.4 lc rgb localised, \
     "fg16_fig7-foot.csv" using 1:6 with lines lw 1.6 lc rgb by_odometry, \
     "fg16_fig7-foot.csv" using 1:9 with lines lw 2 lc rgb combined

# c: where feet come to stand, with the combined approach and by odometry alone
set lmargin at screen 0.55; set rmargin at screen 0.985
set label 3 "{/:Bold c}   From the foothold in the map at touchdown, all feet [cm]" at graph 0, graph 1 \
    offset 0, 0.9 left textcolor rgb ink
set xrange [0:3.1]; set yrange [0:7]
set xtics 0.5; set ytics 1
set xlabel "way [m]" offset 0, 0.5
set key at graph 0.03, graph 0.97 left top vertical maxrows 2 Left reverse samplen 0.6 font small
plot "fg16_fig7-touchdowns.csv" using ($1 == 1 ? $3 : NaN):(100*$10) with points pt 7 ps 0.8 \
         lc rgb by_odometry title "another walk, by odometry alone", \
     "fg16_fig7-touchdowns.csv" using ($1 == 0 ? $3 : NaN):(100*$10) with points pt 7 ps 0.8 \
         lc rgb combined title "combined"
unset multiplot
)";

void draw(figures::StagedFiles& files, const Walk& combined, const Walk& odometry,
          const RobotModel& robot) {
  std::ofstream foot = files.create("fg16_fig7-foot.csv");
  write_foot(foot, combined.tracks);
  foot.close();
  std::ofstream touchdowns = files.create("fg16_fig7-touchdowns.csv");
  write_touchdowns(touchdowns, combined, odometry, robot);
  touchdowns.close();

  const double y = robot.legs[kShown].p_BC.y();
  std::ofstream script = files.create("fg16_fig7.gp");
  script << figures::figure_preamble("fg16_fig7.svg", 1500, 1000)
         << fmt::format("y_min = {:.3f}; zoom = {}\n", y - 0.045, kZoom)
         << "headline = 'Localisation that jumps, odometry that drifts: what Free Gait makes of "
            "both'\n"
         << fmt::format(
                "subtitle = '{} · {:.1f} m by footholds in the map · odometry is off by {:.1f} "
                "cm in the end, for yaw joints that are off by 1° · a fix every {} s · after "
                "[FG16] Fig. 7'\n",
                robot.name, kRoute.end - kRoute.start, 100.0 * combined.summary.odometry_position,
                JumpingLocalisation::Params{}.period)
         << kScript;
  script.close();
  figures::draw_figure(files, "fg16_fig7");
}

// Distances from the footholds of all touchdowns after this way [m].
std::vector<double> errors_from(const Walk& walk, double from, const RobotModel& robot) {
  std::vector<double> errors;
  for (const FootTracks::Touchdown& t : walk.tracks.touchdowns())
    if (way(t, robot) > from) errors.push_back(t.error());
  return errors;
}

LocalisedWalk judged(const Walk& walk, const RobotModel& robot) {
  const double last_metre = kRoute.end - kRoute.start - 1.0;
  return {walk.summary, walk.tracks.commanded_jump(), walk.tracks.localised_jump(),
          errors_from(walk, last_metre, robot), errors_from(walk, -1.0, robot)};
}

}  // namespace

Outcome fg16_fig7(const ExperimentContext& context, figures::StagedFiles& files) {
  const Walk combined = walk(Map::combined, context);
  if (context.progress) context.progress(0.5);
  const Walk odometry = walk(Map::odometry_only, context);
  if (context.stop != nullptr && context.stop->load()) return {};
  draw(files, combined, odometry, *context.robot);
  return {.verdicts =
              judge_localised(judged(combined, *context.robot), judged(odometry, *context.robot),
                              kRoute.end - kRoute.start, JumpingLocalisation::Params{}.shift),
          .settings = {{"robot", context.robot->name},
                       {"terrain", kTerrain},
                       {"seed", std::to_string(kSeed)},
                       {"yaw_error_rad", fmt::format("{}", kYawError)}}};
}

}  // namespace hexagait::experiments
