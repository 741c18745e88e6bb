// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <hexagait/figures/drawing.gp.hpp>
#include <hexagait/figures/drawing.hpp>
#include <hexagait/figures/gnuplot.hpp>

namespace hexagait::figures {
namespace {

constexpr double kHead = 9.0;  // length of an arrow-head [px]

}  // namespace

void Drawing::text(const Vector2& place, const std::string& text, const TextStyle& style) {
  front_ += fmt::format(
      "set label {} at {:.2f},{:.2f} {} front noenhanced font {}('{}', {}) textcolor rgb {}\n",
      in_quotes(text), place.x(), place.y(), style.align, style.mono ? "mono" : "sized",
      style.bold ? ":Bold" : "", style.points, style.colour);
}

void Drawing::box(const Vector2& least, const Vector2& greatest, const std::string& fill) {
  front_ += fmt::format(
      "set object rectangle from {:.2f},{:.2f} to {:.2f},{:.2f} front fc rgb {} fs solid 1 "
      "noborder\n",
      least.x(), least.y(), greatest.x(), greatest.y(), fill);
}

void Drawing::disc(const Vector2& centre, double radius, const std::string& fill,
                   const std::string& border) {
  front_ += fmt::format(
      "set object circle at {0:.2f},{1:.2f} size first {2:.2f} front fc rgb {3} fs solid 1 "
      "noborder\n"
      "set object circle at {0:.2f},{1:.2f} size first {2:.2f} front fs empty border lc rgb {4} "
      "lw 1.2\n",
      centre.x(), centre.y(), radius, fill, border);
}

void Drawing::arrow(const std::vector<Vector2>& points, const std::string& colour,
                    double line_width) {
  const std::string name = fmt::format("$curve{}", ++count_);
  data_ += name + " << EOD\nx,y\n";
  for (const Vector2& p : points) data_ += fmt::format("{:.2f},{:.2f}\n", p.x(), p.y());
  data_ += "EOD\n";
  plots_ += fmt::format("{}{} using \"x\":\"y\" with lines lw {} lc rgb {}",
                        plots_.empty() ? "plot " : ", \\\n     ", name, line_width, colour);

  // The head: a triangle along the last piece.
  const Vector2& tip = points.back();
  const Vector2 along = (tip - points[points.size() - 2]).normalized();
  const Vector2 across(-along.y(), along.x());
  const Vector2 a = tip - kHead * along + 0.36 * kHead * across;
  const Vector2 b = tip - kHead * along - 0.36 * kHead * across;
  front_ += fmt::format(
      "set object polygon from {:.2f},{:.2f} to {:.2f},{:.2f} to {:.2f},{:.2f} to {:.2f},{:.2f} "
      "front fc rgb {} fs solid 1 noborder\n",
      tip.x(), tip.y(), a.x(), a.y(), b.x(), b.y(), tip.x(), tip.y(), colour);
}

void Drawing::draw(StagedFiles& files, const Figure& figure) const {
  draw_figure(files, figure, {},
              std::string(scripts::figures::drawing) + data_ + front_ +
                  (plots_.empty() ? "plot NaN" : plots_));
}

}  // namespace hexagait::figures
