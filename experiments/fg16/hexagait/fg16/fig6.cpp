// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// [FG16] Fig. 6: a list of footholds in the map takes the robot up a step of 12 cm, from four
// starting positions. Somebody pushes the base meanwhile, and one foothold is blocked.
#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <hexagait/fg16/fg16.hpp>
#include <hexagait/fg16/foot_tracks.hpp>
#include <hexagait/fg16/foothold_route.hpp>
#include <hexagait/fg16/judges.hpp>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/walk/action_trial.hpp>

namespace hexagait::experiments {
namespace {

constexpr const char* kTerrain = "step:0.12";
const Route kRoute = {};
const std::array<PlanarPose, 4> kStarts = {
    {{0.0, {0.0, 0.0}}, {0.07, {-0.08, 0.05}}, {-0.10, {0.06, -0.06}}, {0.10, {-0.05, -0.08}}}};
constexpr std::size_t kBlocked = 3;  // the trial with a blocked foothold

// A push every 2.5 s, of half the robot's weight: left, right, back, left.
const std::array<Vector3, 4> kPushes = {
    {{0.0, 250.0, 0.0}, {0.0, -250.0, 0.0}, {-250.0, 0.0, 0.0}, {0.0, 250.0, 0.0}}};
constexpr double kPushSeconds = 0.3, kPushPeriod = 2.5;

// The second foothold of LM: a block of 6 cm stands on it and begins 1 cm before it.
constexpr std::size_t kBlockedPair = 4, kBlockedFoot = 0;
const Vector3 kBlockSize(0.10, 0.16, 0.06);
constexpr double kBlockBegins = -0.01;

struct Climb {
  walk::ActionSummary summary;
  FootTracks tracks;
  std::vector<Vector3> pushed_at;  ///< where the base was [m]
};

sim3d::Block block_on(const Foothold& foothold, double foot_radius) {
  const Vector3 shift(kBlockBegins + 0.5 * kBlockSize.x(), 0.0, 0.5 * kBlockSize.z() - foot_radius);
  return {foothold.p_MF + shift, kBlockSize};
}

Climb climb(std::size_t trial, const ExperimentContext& context,
            std::vector<sim3d::Block>& blocks) {
  const RobotModel& robot = *context.robot;
  const sim3d::TerrainSpec terrain = sim3d::parse_terrain(kTerrain);
  const auto footholds = footholds_along(kRoute, robot, sim3d::Terrain(terrain, 1));
  sim3d::WorldParams params;
  params.start = kStarts[trial];
  if (trial == kBlocked)
    params.blocks = {block_on(footholds[kBlockedPair][kBlockedFoot], robot.foot_radius)};
  blocks = params.blocks;
  sim3d::World world(robot, terrain, params, walk::nominal_posture(robot));

  Climb climb;
  ActionRunner runner(robot);
  double next_push = kPushPeriod + 0.3 * static_cast<double>(trial);
  const auto observe = [&](const ActionRecord&, const GroundTruth& truth) {
    climb.tracks.observe(runner, runner.frames().X_OM, truth);
    if (truth.time >= next_push && climb.pushed_at.size() < kPushes.size()) {
      world.push(kPushes[climb.pushed_at.size()], kPushSeconds);
      climb.pushed_at.push_back(truth.X_WB.p);
      next_push += kPushPeriod;
    }
    return context.stop == nullptr || !context.stop->load();
  };
  const action::Action action = walk_on(footholds, "climb");
  climb.summary = walk::run_action(runner, world, world.truth(), action, {}, observe);
  return climb;
}

using Climbs = std::array<Climb, kStarts.size()>;

// A block of rows for each leg of each trial, in this order; a blank line ends each swing.
void write_feet(std::ostream& out, const Climbs& climbs) {
  out << "time_s,trial,leg,commanded_x_m,commanded_y_m,commanded_z_m,x_m,y_m,z_m,error_m\n";
  for (std::size_t trial = 0; trial < climbs.size(); ++trial) {
    const auto& samples = climbs[trial].tracks.samples();
    for (LegId i = 0; i < 6; ++i) {
      bool swings = true;
      for (const FootTracks::Sample& s : samples) {
        const Vector3 &c = s.commanded[i], &p = s.reached[i];
        if (s.swinging.contains(i))
          fmt::print(out, "{:.2f},{},{},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f}\n", s.time,
                     trial, i, c.x(), c.y(), c.z(), p.x(), p.y(), p.z(), (c - p).norm());
        else if (swings)
          out << '\n';
        swings = s.swinging.contains(i);
      }
      out << "\n\n";
    }
  }
}

void write_touchdowns(std::ostream& out, const Climbs& climbs) {
  out << "time_s,trial,leg,foothold_x_m,foothold_y_m,foothold_z_m,x_m,y_m,z_m,error_m\n";
  for (std::size_t trial = 0; trial < climbs.size(); ++trial)
    for (const FootTracks::Touchdown& t : climbs[trial].tracks.touchdowns())
      fmt::print(out, "{:.3f},{},{},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f}\n", t.time,
                 trial, t.leg, t.foothold.x(), t.foothold.y(), t.foothold.z(), t.reached.x(),
                 t.reached.y(), t.reached.z(), t.error());
}

void write_base(std::ostream& out, const Climbs& climbs) {
  out << "time_s,trial,x_m,y_m,z_m\n";
  for (std::size_t trial = 0; trial < climbs.size(); ++trial) {
    for (const FootTracks::Sample& s : climbs[trial].tracks.samples())
      fmt::print(out, "{:.2f},{},{:.5f},{:.5f},{:.5f}\n", s.time, trial, s.X_MB.p.x(), s.X_MB.p.y(),
                 s.X_MB.p.z());
    out << "\n\n";
  }
}

void write_pushes(std::ostream& out, const Climbs& climbs) {
  out << "trial,x_m,y_m,force_x_n,force_y_n\n";
  for (std::size_t trial = 0; trial < climbs.size(); ++trial)
    for (std::size_t k = 0; k < climbs[trial].pushed_at.size(); ++k)
      fmt::print(out, "{},{:.5f},{:.5f},{},{}\n", trial, climbs[trial].pushed_at[k].x(),
                 climbs[trial].pushed_at[k].y(), kPushes[k].x(), kPushes[k].y());
}

// Share of the swing samples whose error is less.
void write_shares(std::ostream& out, const Climbs& climbs) {
  out << "trial,error_m,share\n";
  for (std::size_t trial = 0; trial < climbs.size(); ++trial) {
    const std::vector<double> errors = climbs[trial].tracks.swing_errors();
    for (int k = 0; k <= 200; ++k)
      fmt::print(out, "{},{:.6f},{:.4f}\n", trial, walk::percentile(errors, k / 200.0), k / 200.0);
    out << "\n\n";
  }
}

constexpr const char* kScript = R"(
set multiplot
set label 1 headline at screen 0.045, 0.965 left noenhanced font sized("", 15) textcolor rgb ink
set label 2 subtitle at screen 0.045, 0.937 left noenhanced font sized("", 10.5) textcolor rgb grey
array colour[4] = ["#2f6f9f", "#c99a2e", "#2c7a57", "#c4472b"]
names = "A B C D"
small = sized("", 9)

# a, b: the feet from the side. The ground up to the step and behind it
do for [side=0:1] {
  set lmargin at screen 0.045; set rmargin at screen 0.985
  bottom = side == 0 ? 0.7 : 0.46
  set bmargin at screen bottom; set tmargin at screen bottom + 0.165
  set label 3 sprintf("{/:Bold %s}   %s feet from the side: height over way [m]", \
      side == 0 ? "a" : "b", side == 0 ? "Left" : "Right") at graph 0, graph 1 \
      offset 0, 0.9 left textcolor rgb ink
  set xrange [-0.72:1.82]; set yrange [0:0.3]
  set xtics 0.2; set ytics 0.1
  set object 1 rectangle from 0.6, 0 to 1.82, 0.12 fs solid 0.35 noborder fc rgb earth behind
  if (side == 0) {
    set object 2 rectangle from block_x, 0 to block_x + 0.1, 0.06 fs solid 0.8 noborder \
        fc rgb "#6b5a42" behind
    set label 4 "block, in D" at 0.607, 0.02 left textcolor rgb ink font small
  }
  if (side == 0) { set key at graph 1, graph 1.03 right bottom horizontal samplen 1.6 width -2 font small }
  if (side == 1) { unset key }
  plot for [k=0:3] for [j=0:2] "fg16_fig6-feet.csv" index (6*k + 2*j + side) \
           using 4:($6 - foot_radius) with lines lw 5 lc rgb "#c3ccd4" \
           title (k + j == 0 ? "commanded" : ""), \
       for [k=0:3] for [j=0:2] "fg16_fig6-feet.csv" index (6*k + 2*j + side) \
           using 7:($9 - foot_radius) with lines lw 1.3 lc rgb colour[k+1] \
           title (j == 0 ? word(names, k+1) : "")
  unset object 1; unset object 2; unset label 4; unset label 1; unset label 2
}

# c: from above, a metre as long across as up: feet as dots where they came to stand, the base, the pushes
set lmargin at screen 0.045; set rmargin at screen 0.475
set bmargin at screen 0.055; set tmargin at screen 0.055 + 0.43*width*1.36/2.54/height
set label 3 "{/:Bold c}   From above: footholds, feet that stand on them, base and pushes [m]" \
    at graph 0, graph 1 offset 0, 0.9 left textcolor rgb ink
set xrange [-0.72:1.82]; set yrange [-0.68:0.68]
set xtics 0.5; set ytics 0.5
set object 1 rectangle from 0.6, -0.68 to 1.82, 0.68 fs solid 0.2 noborder fc rgb earth behind
set object 2 rectangle from block_x, block_y - 0.08 to block_x + 0.1, block_y + 0.08 \
    fs solid 0.8 noborder fc rgb "#6b5a42" behind
unset key
plot "fg16_fig6-touchdowns.csv" using 4:5 with points pt 6 ps 1.5 lw 2.5 lc rgb "#c3ccd4", \
     for [k=0:3] "fg16_fig6-touchdowns.csv" using ($2 == k ? $7 : NaN):8 with points pt 7 ps 0.45 \
         lc rgb colour[k+1], \
     for [k=0:3] "fg16_fig6-base.csv" index k using 3:4 with lines lw 1.4 lc rgb colour[k+1], \
     for [k=0:3] "fg16_fig6-pushes.csv" using ($1 == k ? $2 : NaN):3:($4/1250):($5/1250) with vectors \
         head filled size screen 0.006, 22 lw 1.6 lc rgb colour[k+1]
unset object 1; unset object 2

# d: how near the feet are to where they should be
set lmargin at screen 0.55; set rmargin at screen 0.985
set label 3 "{/:Bold d}   Distance of a swinging foot from its command: share of the time" \
    at graph 0, graph 1 offset 0, 0.9 left textcolor rgb ink
set logscale x; set xrange [0.1:100]; set yrange [0:1]
set xtics ("0.1" 0.1, "1" 1, "10" 10, "100" 100); set ytics 0.25
set format y "%g"
set xlabel "less than … [mm]" offset 0, 0.4
set key at graph 0.98, graph 0.06 right bottom Left reverse samplen 1.6 font small
plot for [k=0:3] "fg16_fig6-shares.csv" index k using (1e3*$2):3 with lines lw 1.8 lc rgb colour[k+1] \
    title word(legends, k+1)
unset multiplot
)";

std::string legends(const Climbs& climbs) {
  std::string text;
  for (std::size_t k = 0; k < climbs.size(); ++k) {
    const std::vector<double> errors = climbs[k].tracks.swing_errors();
    text += fmt::format("\"{}: median {:.1f} mm, 95 % {:.1f} mm{}\" ", "ABCD"[k],
                        1e3 * walk::percentile(errors, 0.5), 1e3 * walk::percentile(errors, 0.95),
                        k == kBlocked ? ", blocked" : "");
  }
  return text;
}

void draw(figures::StagedFiles& files, const Climbs& climbs, const sim3d::Block& block,
          const RobotModel& robot) {
  const auto write = [&](const char* name, auto writer) {
    std::ofstream csv = files.create(fmt::format("fg16_fig6-{}.csv", name));
    writer(csv, climbs);
  };
  write("feet", write_feet);
  write("touchdowns", write_touchdowns);
  write("base", write_base);
  write("pushes", write_pushes);
  write("shares", write_shares);
  std::ofstream script = files.create("fg16_fig6.gp");
  script << figures::figure_preamble("fg16_fig6.svg", 1500, 1100)
         << fmt::format("foot_radius = {}; block_x = {:.4f}; block_y = {:.4f}\n", robot.foot_radius,
                        block.centre.x() - 0.5 * block.size.x(), block.centre.y())
         << "headline = 'Up a step of 12 cm by a list of footholds, from four starting positions'\n"
         << fmt::format(
                "subtitle = '{} · Footstep and BaseAuto · in each trial four pushes of {:.0f} "
                "N for {} s · a foothold blocked in D · after [FG16] Fig. 6'\n",
                robot.name, kPushes.front().norm(), kPushSeconds)
         << "legends = " << figures::quoted(legends(climbs)) << '\n'
         << kScript;
  script.close();
  figures::draw_figure(files, "fg16_fig6");
}

std::vector<Verdict> judge(const Climbs& climbs, const RobotModel& robot) {
  std::vector<Climbed> judged;
  for (const Climb& c : climbs)
    judged.push_back({c.summary, c.tracks.swing_errors(), c.tracks.touchdowns()});
  const auto footholds =
      footholds_along(kRoute, robot, sim3d::Terrain(sim3d::parse_terrain(kTerrain), 1));
  const Foothold& blocked = footholds[kBlockedPair][kBlockedFoot];
  return judge_climbs(judged, judged[kBlocked], blocked.leg, blocked.p_MF);
}

}  // namespace

Outcome fg16_fig6(const ExperimentContext& context, figures::StagedFiles& files) {
  Climbs climbs;
  std::vector<sim3d::Block> blocks;
  for (std::size_t k = 0; k < climbs.size(); ++k) {
    climbs[k] = climb(k, context, blocks);
    if (context.stop != nullptr && context.stop->load()) return {};
    if (context.progress)
      context.progress(static_cast<double>(k + 1) / static_cast<double>(climbs.size()));
  }
  draw(files, climbs, blocks.front(), *context.robot);
  return {.verdicts = judge(climbs, *context.robot),
          .settings = {
              {"robot", context.robot->name},
              {"terrain", kTerrain},
              {"trials", std::to_string(climbs.size())},
              {"push", fmt::format("{:.0f} N for {} s", kPushes.front().norm(), kPushSeconds)}}};
}

}  // namespace hexagait::experiments
