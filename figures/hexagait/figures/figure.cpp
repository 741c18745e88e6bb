// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <hexagait/figures/figure.hpp>
#include <hexagait/figures/gnuplot.hpp>
#include <hexagait/figures/preamble.gp.hpp>

namespace hexagait::figures {
namespace {

std::string range(std::string_view name, const Box& box) {
  return fmt::format("{}_range = 'set xrange [{:.4f}:{:.4f}]; set yrange [{:.4f}:{:.4f}]'\n", name,
                     box.least.x(), box.greatest.x(), box.least.y(), box.greatest.y());
}

template <class Spell>
std::string array(std::string_view name, std::size_t size, Spell spell) {
  std::string text = fmt::format("array {}[{}] = [", name, size);
  for (std::size_t k = 0; k < size; ++k) text += (k > 0 ? ", " : "") + spell(k);
  return text + "]\n";
}

struct Assignment {
  std::string_view name;

  std::string operator()(int value) const { return fmt::format("{} = {}\n", name, value); }
  // A decimal point, lest gnuplot divide as integers do.
  std::string operator()(double value) const { return fmt::format("{} = {:#.9g}\n", name, value); }
  std::string operator()(const std::string& value) const {
    return fmt::format("{} = {}\n", name, in_quotes(value));
  }
  std::string operator()(const std::vector<double>& values) const {
    return array(name, values.size(), [&](auto k) { return fmt::format("{:#.9g}", values[k]); });
  }
  std::string operator()(const std::vector<std::string>& values) const {
    return array(name, values.size(), [&](auto k) { return in_quotes(values[k]); });
  }
  std::string operator()(const Panel& p) const {
    return fmt::format("{0}_panel = panel({1}, {2}, {3}, {4}); {0}_top = {4}\n", name, p.left,
                       p.right, p.bottom, p.top);
  }
  std::string operator()(const Box& box) const { return range(name, box); }
};

}  // namespace

void Variables::set(std::string_view name, const Value& value) {
  text_ += std::visit(Assignment{name}, value);
}

void draw_figure(StagedFiles& files, const Figure& figure, const Variables& variables,
                 std::string_view script) {
  std::vector<std::string> suffixes = {figure.suffix};
  if (figure.suffix.empty()) suffixes = {".svg", ".pdf", ".png"};
  const Variables sheet = {{"width", figure.width},
                           {"height", figure.height},
                           {"stem", figure.stem},
                           {"headline", figure.headline},
                           {"subtitle", figure.subtitle}};
  files.write(figure.stem + ".gp",
              fmt::format("# gnuplot -e \"figure='other.svg'\" draws it as .svg, .pdf or .png.\n"
                          "if (!exists(\"figure\")) figure = {}\n{}{}{}\n{}\nunset multiplot\n",
                          in_quotes(figure.stem + suffixes.front()), sheet.text(),
                          scripts::figures::preamble, variables.text(), script));
  for (const std::string& suffix : suffixes) {
    if (figure.suffix.empty()) files.expect(figure.stem + suffix);
    run_gnuplot(files.staging(), figure.stem + ".gp", figure.stem + suffix);
  }
}

}  // namespace hexagait::figures
