// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/all/all.hpp>
#include <hexagait/fg16/fg16.hpp>
#include <hexagait/gallery/gallery.hpp>
#include <hexagait/paths/paths.hpp>
#include <hexagait/pc04/pc04.hpp>
#include <hexagait/rough/lead.hpp>
#include <hexagait/rough/rough.hpp>
#include <hexagait/sensitivity/sensitivity.hpp>

namespace hexagait::experiments {

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> all = {
      {"table1", "[PC04] Table 1: the gait states by circularity number and type", table1},
      {"table2", "[PC04] Table 2: how the tripod gait comes about", table2},
      {"fig3", "[PC04] Fig. 3: wave gaits, and the types of their gait states", fig3},
      {"fig4", "[PC04] Fig. 4: transitions between the gait states with CCN = 3", fig4},
      {"fig6", "[PC04] Fig. 6: the first steps, of three gait generators", fig6},
      {"fig7a", "[PC04] Fig. 7-A: mean speed on flat ground", fig7a},
      {"fig7b", "[PC04] Fig. 7-B: mean speed on rough ground", fig7b},
      {"fig7_physics", "[PC04] Fig. 7 once more: Genghis in Box2D, on rougher and rougher ground",
       fig7_physics},
      {"fig9", "[PC04] Fig. 9: straight lines, a turn in place and a curve, on flat ground", fig9,
       true, "the walk"},
      {"fig10", "[PC04] Fig. 10: a turn to the left on abrupt terrain", fig10, true, "the walk"},
      {"fig11", "[PC04] Fig. 11: a spider-like robot that receives headings at random", fig11, true,
       "the walk"},
      {"fig12", "[PC04] Fig. 12: Lauron's feet slip by less than 1 cm with discrete displacements",
       fig12, false, "straight on, with displacements at 20 Hz"},
      {"navigation",
       "[PC04] 5.2: Genghis among walls and cliffs for an hour, by whiskers and infrared",
       navigation, false, "the first two minutes in the first arena"},
      {"wave_family",
       "[PC04] 3.2: wave gaits of every duty factor, 1/2 to 5/6 and back, in one walk", wave_family,
       true, "the walk"},
      {"fg16_fig6", "[FG16] Fig. 6: up a step by footholds in the map, pushed and blocked",
       fg16_fig6, false, "the first of the four climbs"},
      {"fg16_fig7",
       "[FG16] Fig. 7: localisation that jumps, odometry that drifts, and both combined", fg16_fig7,
       false, "the walk with both combined"},
      {"walks", "the walks by which the controller is judged: headings, postures, terrain", walks,
       true, "an arc over boxes, as ./run walks it"},
      {"rates", "control periods of 1 to 20 ms: ten headings on flat ground, and boxes", rates,
       true, "straight on over boxes with the longest period"},
      {"path", "paths that are given: a figure of eight and a square, flat ground and boxes", path,
       true, "the figure of eight over boxes, by odometry"},
      {"rough", "success and cost against the height of boxes, of four controllers", rough, true,
       "the free gait over boxes of a third of the reach of a leg"},
      {"lead", "how far ahead of the waiting tripod the times of steps let the free gait be", lead,
       true, "the first walk"},
      {"sensitivity", "what each imperfection of a robot costs, and at which size it breaks",
       sensitivity, false, "the plant real over boxes"},
      {"gallery", "every robot in robots/: flat ground and boxes", gallery, true,
       "the first robot over boxes"},
      {"random_robots", "robots that nobody has seen before: straight on, an arc and a spin",
       random_robots, false, "the first robot that can stand, straight on"},
  };
  return all;
}

}  // namespace hexagait::experiments
