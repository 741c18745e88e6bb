// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/figures/figure.hpp>
#include <hexagait/figures/gnuplot.hpp>

namespace hexagait::figures {

void draw_figure(StagedFiles& files, const Figure& figure, int width, int height,
                 const std::string& commands) {
  std::ofstream script = files.create(figure.stem + ".gp");
  script << figure_preamble(figure.stem + figure.suffix, width, height) << commands;
  script.close();
  run_gnuplot(files.staging(), figure.stem + ".gp", figure.stem + figure.suffix);
}

}  // namespace hexagait::figures
