// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause

// Every robot that comes with hexagait: flat ground and boxes.
#include <fmt/format.h>

#include <algorithm>
#include <hexagait/experiments/on_workers.hpp>
#include <hexagait/gallery/gallery.hpp>
#include <hexagait/gallery/robot_tally.hpp>
#include <hexagait/recording/figures/robot_sheet.hpp>

namespace hexagait::experiments {
namespace {

constexpr double kCell = 0.3;  // width of the boxes, in L

// Robots with legs of two joints can't crab.
std::vector<RobotHeading> headings(const GalleryRobot& robot) {
  std::vector<RobotHeading> all = {straight_on(robot.scale), along_an_arc(robot.scale), in_place()};
  if (std::ranges::none_of(robot.model.legs, &LegModel::has_two_joints))
    all.push_back(sideways(robot.scale));
  return all;
}

// What a robot is to walk. Over boxes each seed has one of the headings, in turn.
void plan(GalleryRobot& robot, bool brief) {
  const std::vector<RobotHeading> all = headings(robot);
  for (const RobotHeading& heading : all)
    if (!brief || heading.name == "spin") robot.walks.push_back({robot.model.name, heading.name});
  for (std::uint64_t seed = 1; seed <= (brief ? 1 : 20); ++seed)
    robot.walks.push_back({robot.model.name, all[(seed - 1) % all.size()].name, robot.boxes, seed});
}

RobotHeading heading_of(const GalleryRobot& robot, const GalleryWalk& walk) {
  const std::vector<RobotHeading> all = headings(robot);
  return *std::ranges::find(all, walk.heading, &RobotHeading::name);
}

recording::Simulation simulation_of(const ExperimentContext& context, const GalleryRobot& robot,
                                    const GalleryWalk& walk, const RobotHeading& heading) {
  recording::Simulation simulation = walk_of(heading, robot.scale);
  simulation.plant = context.plant;
  simulation.seed = walk.seed;
  if (walk.height > 0.0) {
    simulation.terrain = {sim3d::TerrainKind::boxes, walk.height};
    simulation.terrain.parts[0].extent = kCell * robot.scale.size;
  }
  return simulation;
}

void walk_it(const ExperimentContext& context, const GalleryRobot& robot, GalleryWalk& walk) {
  RobotHeading heading = heading_of(robot, walk);
  if (context.short_form) heading.distance *= 0.1;
  const recording::Simulation simulation = simulation_of(context, robot, walk, heading);
  walk.end =
      end_of(recording::simulate(robot.model, simulation, {}, context.stop), heading, robot.model);
}

void show_boxes(const ExperimentContext& context, const GalleryRobot& robot) {
  const GalleryWalk walk = robot.walks_on(true).front();
  show(robot.model, simulation_of(context, robot, walk, heading_of(robot, walk)), context);
}

bool walk_all(const ExperimentContext& context, std::vector<GalleryRobot>& robots) {
  std::vector<std::pair<const GalleryRobot*, GalleryWalk*>> walks;
  for (GalleryRobot& robot : robots)
    for (GalleryWalk& walk : robot.walks) walks.emplace_back(&robot, &walk);
  return all_rows(
      context,
      fmt::format("gallery{} with the plant {}", context.short_form ? " in short" : "",
                  context.plant.name),
      walks.size(),
      [&](std::uint64_t k, const std::string& row) { walks[k - 1].second->end = parse_end(row); },
      [&](std::uint64_t k) { walk_it(context, *walks[k - 1].first, *walks[k - 1].second); },
      [&](std::uint64_t k) { return to_line(walks[k - 1].second->end); });
}

void draw(figures::StagedFiles& files, const ExperimentContext& context,
          const std::vector<GalleryRobot>& robots) {
  std::vector<recording::Pictured> pictures;
  pictures.reserve(robots.size());
  for (const GalleryRobot& r : robots)
    pictures.push_back(
        {r.model, fmt::format("{} legs of {} joints, {:.3g} kg, L = {:.2f} m", r.scale.legs,
                              r.model.legs[0].num_joints(), r.model.mass, r.scale.size)});
  recording::draw_robots(files,
                         context.figure("gallery", 0, 0, "Every robot in robots/",
                                        "In their stances, from above and from the side · left "
                                        "legs blue, right legs yellow"),
                         pictures);
}

}  // namespace

Outcome gallery(const ExperimentContext& context, figures::StagedFiles& files) {
  std::vector<GalleryRobot> robots;
  for (const std::string& name : context.robot_names) {
    RobotModel model = context.robot_named(name);
    model.name = name;
    robots.push_back(in_gallery(model));
    plan(robots.back(), context.short_form);
  }
  if (!walk_all(context, robots)) return {};
  if (!robots.empty()) show_boxes(context, robots.front());
  const figures::Csv rows = table(robots);
  files.write("gallery.csv", rows.text());
  files.write("gallery.md", gallery_page(robots, context.plant.name, context.short_form));
  draw(files, context, robots);

  const std::vector<Verdict> verdicts = {judge_flat(robots), judge_boxes(robots)};
  return {.verdicts = judged_in_full_only(verdicts, context.short_form),
          .settings = {{"robots", std::to_string(robots.size())}},
          .table = rows};
}

}  // namespace hexagait::experiments
