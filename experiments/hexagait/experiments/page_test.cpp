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
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// A directory with one experiment, whose figure has the bytes `figure`; the page made of it.
std::string page_of(const Manifest& manifest, const std::string& figure) {
  std::string pattern = testing::TempDir() + "hexagait-page-XXXXXX";
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
  Manifest manifest{"fig0", "A figure", {}, {{"fig0.svg", 0}, {"fig0.csv", 0}}};
  manifest.outcome.verdicts = std::move(verdicts);
  return manifest;
}

TEST(Page, SaysOfEachClaimWhetherItHoldsAndWhyNotIfThatIsKnown) {
  const std::string html = page_of(manifest_of({{"It goes", true, "1 m/s"},
                                                {"It flies", false, "0 m"},
                                                {"It swims", false, "0 m", "no fins"}}),
                                   "");
  EXPECT_THAT(html, AllOf(HasSubstr("<li class=\"yes\"><span class=\"verdict\">holds"),
                          HasSubstr("<li class=\"no\"><span class=\"verdict\">does not hold"),
                          HasSubstr("<li class=\"known\">"), HasSubstr("Known: no fins.")));
  EXPECT_THAT(html, HasSubstr("1 of 3"));
}

// The figures are in it, byte for byte: RFC 4648 10, "foobar" is Zm9vYmFy, "fooba" Zm9vYmE=, "foob"
// Zm9vYg==.
TEST(Page, ContainsItsFiguresAndLinksItsTables) {
  EXPECT_THAT(page_of(manifest_of({}), "foobar"), HasSubstr("base64,Zm9vYmFy\""));
  EXPECT_THAT(page_of(manifest_of({}), "fooba"), HasSubstr("base64,Zm9vYmE=\""));
  EXPECT_THAT(page_of(manifest_of({}), "foob"), HasSubstr("base64,Zm9vYg==\""));
  EXPECT_THAT(page_of(manifest_of({}), ""),
              AllOf(HasSubstr("href=\"fig0/fig0.csv\""), HasSubstr("href=\"fig0/manifest.json\"")));
}

TEST(Page, WritesTextAsTextAndTakesNothingFromElsewhere) {
  const std::string html = page_of(manifest_of({{"a < b & \"c\"", true, "<><>"}}), "");
  EXPECT_THAT(html, HasSubstr("a &lt; b &amp; &quot;c&quot;"));
  EXPECT_THAT(html, HasSubstr("&lt;&gt;&lt;&gt;"));
  EXPECT_THAT(html, AllOf(Not(HasSubstr("http")), Not(HasSubstr("<script"))));
}

TEST(Verdict, ThatDoesNotHoldIsAccountedForByAReason) {
  EXPECT_TRUE((Verdict{"", true, ""}.is_accounted_for()));
  EXPECT_FALSE((Verdict{"", false, ""}.is_accounted_for()));
  EXPECT_TRUE((Verdict{"", false, "", "a reason"}.is_accounted_for()));
}

}  // namespace
}  // namespace hexagait::experiments
