// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/figures/staged_files.hpp>
#include <string>

namespace hexagait::figures {

/// A figure that a user asks for by name, as opposed to those of experiments.
struct Figure {
  std::string stem;    ///< names of all files, without their endings
  std::string suffix;  ///< ".png", ".svg" or ".pdf"
  std::string headline, subtitle;
};

/// Writes stem.gp and runs it: the preamble for a sheet of width × height [px], and `commands`,
/// which draw from the files that are there already. The caller has registered stem.suffix.
/// @throws std::runtime_error  if gnuplot fails
void draw_figure(StagedFiles& files, const Figure& figure, int width, int height,
                 const std::string& commands);

}  // namespace hexagait::figures
