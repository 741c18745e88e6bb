// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <hexagait/experiments/page.hpp>
#include <hexagait/experiments/page.html.hpp>
#include <hexagait/figures/base64.hpp>
#include <hexagait/recording/version.hpp>
#include <iterator>

namespace hexagait::experiments {
namespace {

namespace fs = std::filesystem;

std::string escaped(const std::string& text) {
  constexpr std::pair<char, std::string_view> kEntities[] = {
      {'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}, {'"', "&quot;"}};
  std::string html;
  for (const char letter : text) {
    const auto* const entity =
        std::ranges::find(kEntities, letter, &std::pair<char, std::string_view>::first);
    html += entity == std::end(kEntities) ? std::string_view(&letter, 1) : entity->second;
  }
  return html;
}

std::string content(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string claims_html(const std::vector<Verdict>& verdicts) {
  std::string html = "<ul class=\"claims\">\n";
  for (const Verdict& v : verdicts) {
    const char* const kind = !v.is_accounted_for() ? "no" : v.holds() ? "yes" : "known";
    html += fmt::format("<li class=\"{}\"><span class=\"verdict\">{}</span><span>{}</span>\n", kind,
                        v.word(), escaped(v.claim));
    for (const std::string& line : v.lines())
      html += fmt::format("<span class=\"numbers\">{}</span>\n", escaped(line));
    html += "</li>\n";
  }
  return html + "</ul>\n";
}

std::string row_html(const std::vector<std::string>& cells, const char* tag) {
  std::string html = "<tr>";
  for (const std::string& cell : cells) html += fmt::format("<{0}>{1}</{0}>", tag, escaped(cell));
  return html + "</tr>\n";
}

std::string table_html(const figures::Csv& table) {
  if (table.rows().empty()) return {};
  std::string html =
      "<details><summary>Numbers</summary>\n<table>\n" + row_html(table.header(), "th");
  for (const auto& row : table.rows()) html += row_html(row, "td");
  return html + "</table></details>\n";
}

std::string figures_html(const Manifest& manifest, const fs::path& directory) {
  std::string html;
  for (const Manifest::Output& output : manifest.outputs)
    if (output.name.ends_with(".svg"))
      html +=
          fmt::format("<figure><img alt=\"{}\" src=\"data:image/svg+xml;base64,{}\"></figure>\n",
                      escaped(manifest.title), figures::base64(content(directory / output.name)));
  return html;
}

std::string files_html(const Manifest& manifest, const fs::path& directory) {
  std::string html = "<p class=\"files\">";
  std::vector<std::string> names;
  for (const Manifest::Output& output : manifest.outputs) {
    names.push_back(output.name);
    const std::string pdf = fs::path(output.name).replace_extension(".pdf").string();
    if (output.name.ends_with(".svg") && fs::exists(directory / pdf)) names.push_back(pdf);
  }
  names.emplace_back("manifest.json");
  for (const std::string& name : names)
    html += fmt::format("{}<a href=\"{}/{}\">{}</a>", &name == &names.front() ? "" : " · ",
                        manifest.experiment, name, name);
  return html + "</p>\n";
}

std::string overview_html(const std::vector<Manifest>& manifests) {
  std::string html =
      "<table class=\"overview\"><tr><th>experiment</th><th></th><th>claims that hold</th></tr>\n";
  for (const Manifest& m : manifests) {
    const auto holding =
        std::ranges::count_if(m.outcome.verdicts, [](const Verdict& v) { return v.holds(); });
    html +=
        fmt::format("<tr><td><a href=\"#{0}\">{0}</a></td><td>{1}</td><td>{2} of {3}</td></tr>\n",
                    m.experiment, escaped(m.title), holding, m.outcome.verdicts.size());
  }
  return html + "</table>\n";
}

}  // namespace

void write_page(const std::vector<Manifest>& manifests, const fs::path& out) {
  figures::StagedFiles files(out);
  std::string html(scripts::experiments::page);
  html += fmt::format("{} ({}). What does not hold is said so, with the numbers.</p>\n",
                      recording::kVersion, recording::kRevision) +
          overview_html(manifests);
  for (const Manifest& manifest : manifests) {
    const fs::path directory = out / manifest.experiment;
    html += fmt::format("<section id=\"{0}\">\n<h2><small>{0}</small>{1}</h2>\n",
                        manifest.experiment, escaped(manifest.title)) +
            claims_html(manifest.outcome.verdicts) + figures_html(manifest, directory) +
            table_html(manifest.outcome.table) + files_html(manifest, directory) + "</section>\n";
  }
  files.write("index.html", html + "</html>\n");
  files.publish();
}

}  // namespace hexagait::experiments
