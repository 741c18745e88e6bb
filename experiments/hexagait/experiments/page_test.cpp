// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>
#include <hexagait/experiments/page.hpp>
#include <iterator>

namespace hexagait::experiments {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// A directory with one experiment, whose figure has the bytes `figure`; the page made of it.
std::string page_of(const Manifest& manifest, const std::string& figure) {
  std::string pattern = ::testing::TempDir() + "hexagait-page-XXXXXX";
  const fs::path out = mkdtemp(pattern.data());
  fs::create_directory(out / manifest.experiment);
  for (const Manifest::Output& output : manifest.outputs)
    std::ofstream(out / manifest.experiment / output.name) << figure;
  write_page({manifest}, out);
  std::ifstream page(out / "index.html");
  const std::string html{std::istreambuf_iterator<char>(page), {}};
  fs::remove_all(out);
  return html;
}

Manifest manifest_of(std::vector<Verdict> verdicts) {
  Manifest manifest{"fig0", "A figure", false, {}, {{"fig0.svg", 0}, {"fig0.csv", 0}}};
  manifest.outcome.verdicts = std::move(verdicts);
  return manifest;
}

Check height(double metres) { return {{"height", "m", metres}, at_least(1.0)}; }

TEST(Page, SaysOfEachClaimWhetherItHoldsAndWhyNotIfThatIsExpected) {
  const std::string html = page_of(
      manifest_of(
          {{.claim = "It goes", .checks = {height(2.0)}},
           {.claim = "It flies", .checks = {height(0.0)}},
           {.claim = "It swims",
            .checks = {height(0.5).expected_to_fail(between(0.4, 0.6), "it has no fins")}}}),
      "");
  EXPECT_THAT(html, AllOf(HasSubstr("<li class=\"yes\"><span class=\"verdict\">holds"),
                          HasSubstr("<li class=\"no\"><span class=\"verdict\">FAILS"),
                          HasSubstr("<li class=\"known\">"), HasSubstr("it has no fins")));
  EXPECT_THAT(html, HasSubstr("1 of 3"));
}

// The figures are in it, byte for byte: as base64, "foobar" is Zm9vYmFy.
TEST(Page, ContainsItsFiguresAndLinksItsTables) {
  EXPECT_THAT(page_of(manifest_of({}), "foobar"), HasSubstr("base64,Zm9vYmFy\""));
  EXPECT_THAT(page_of(manifest_of({}), ""),
              AllOf(HasSubstr("href=\"fig0/fig0.csv\""), HasSubstr("href=\"fig0/manifest.json\"")));
}

TEST(Page, WritesTextAsTextAndTakesNothingFromElsewhere) {
  const std::string html =
      page_of(manifest_of({{.claim = "a < b & \"c\"", .checks = {}, .remark = "<><>"}}), "");
  EXPECT_THAT(html, HasSubstr("a &lt; b &amp; &quot;c&quot;"));
  EXPECT_THAT(html, HasSubstr("&lt;&gt;&lt;&gt;"));
  EXPECT_THAT(html, AllOf(Not(HasSubstr("http")), Not(HasSubstr("<script"))));
}

}  // namespace
}  // namespace hexagait::experiments
