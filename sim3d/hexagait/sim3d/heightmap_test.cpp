// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <hexagait/sim3d/terrain.hpp>
#include <hexagait/text/invalid_input.hpp>

namespace hexagait::sim3d {
namespace {

namespace fs = std::filesystem;

// Grey, of 3 × 2 pixels of 8 bits: 0 51 255 above 102 153 204.
const std::vector<unsigned char> kGrey8 = {
    137, 80,  78,  71,  13,  10, 26, 10, 0,   0,   0,   13, 73,  72,  68, 82, 0,   0,  0,
    3,   0,   0,   0,   2,   8,  0,  0,  0,   0,   184, 31, 57,  198, 0,  0,  0,   16, 73,
    68,  65,  84,  120, 156, 99, 96, 48, 254, 207, 144, 54, 243, 12,  0,  9,  101, 2,  254,
    161, 119, 156, 233, 0,   0,  0,  0,  73,  69,  78,  68, 174, 66,  96, 130};

// Grey, of 2 × 2 pixels of 16 bits: 0 65535 above 13107 26214.
const std::vector<unsigned char> kGrey16 = {
    137, 80, 78,  71,  13,  10,  26, 10, 0,   0,   0,   13,  73,  72,  68,  82, 0,  0,  0,
    2,   0,  0,   0,   2,   16,  0,  0,  0,   0,   7,   77,  142, 187, 0,   0,  0,  18, 73,
    68,  65, 84,  120, 156, 99,  96, 96, 248, 255, 159, 193, 216, 56,  45,  13, 0,  15, 148,
    3,   49, 109, 160, 3,   124, 0,  0,  0,   0,   73,  69,  78,  68,  174, 66, 96, 130};

const std::vector<unsigned char> kColoured = {
    137, 80, 78, 71,  13,  10, 26, 10,  0,  0,  0,   13,  73,  72,  68, 82, 0,   0,  0,
    2,   0,  0,  0,   2,   8,  2,  0,   0,  0,  253, 212, 154, 115, 0,  0,  0,   16, 73,
    68,  65, 84, 120, 156, 99, 96, 100, 98, 6,  34,  6,   8,   5,   0,  0,  174, 0,  25,
    135, 46, 28, 157, 0,   0,  0,  0,   73, 69, 78,  68,  174, 66,  96, 130};

class Heightmaps : public ::testing::Test {
 protected:
  Heightmaps() {
    directory_ = fs::path(::testing::TempDir()) /
                 ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::create_directories(directory_);
  }
  ~Heightmaps() override { fs::remove_all(directory_); }
  Heightmaps(const Heightmaps&) = delete;
  Heightmaps& operator=(const Heightmaps&) = delete;

  template <class Bytes>
  std::string file(const std::string& name, const Bytes& bytes) {
    const std::string path = (directory_ / name).string();
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(std::data(bytes)),
               static_cast<std::streamsize>(std::size(bytes)));
    return path;
  }
  std::string text(const std::string& name, const std::string& content) {
    return file(name, content);
  }

  fs::path directory_;
};

std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "none";
}

#ifdef HEXAGAIT_HAS_PNG
TEST_F(Heightmaps, ReadGreyPngsOf8And16Bits) {
  const Heightmap small = load_heightmap(file("8.png", kGrey8));
  EXPECT_EQ(small.columns, 3);
  EXPECT_EQ(small.rows, 2);
  EXPECT_THAT(small.levels, ::testing::Pointwise(::testing::FloatNear(1e-6F),
                                                 {0.0F, 0.2F, 1.0F, 0.4F, 0.6F, 0.8F}));
  EXPECT_THAT(load_heightmap(file("16.png", kGrey16)).levels,
              ::testing::Pointwise(::testing::FloatNear(1e-6F), {0.0F, 1.0F, 0.2F, 0.4F}));
}

TEST_F(Heightmaps, RefuseColoursAndDamage) {
  EXPECT_THAT(
      refusal([&] { (void)load_heightmap(file("c.png", kColoured)); }),
      ::testing::AllOf(::testing::HasSubstr("c.png"), ::testing::HasSubstr("must be grey")));
  auto cut = kGrey8;
  cut.resize(cut.size() - 30);
  EXPECT_THAT(refusal([&] { (void)load_heightmap(file("cut.png", cut)); }),
              ::testing::HasSubstr("cut.png"));
}
#endif

TEST_F(Heightmaps, ReadTables) {
  const Heightmap map = load_heightmap(text("t.csv", "0, 0.5,1\r\n-1,2e-1,3\n"));
  EXPECT_EQ(map.columns, 3);
  EXPECT_EQ(map.rows, 2);
  EXPECT_EQ(map.levels[3], -1.0F);
  EXPECT_EQ(map.lowest(), -1.0);
  EXPECT_EQ(map.highest(), 3.0);
  EXPECT_DOUBLE_EQ(map.at(0.5, 0.0), 0.25);
  EXPECT_DOUBLE_EQ(map.at(0.0, 0.5), -0.5);
  EXPECT_DOUBLE_EQ(map.at(-7.0, 9.0), -1.0) << "beyond the edges as on them";
}

TEST_F(Heightmaps, SayInOneLineWhatIsWrongWithATable) {
  const auto problem = [&](const std::string& content) {
    return refusal([&] { (void)load_heightmap(text("bad.csv", content)); });
  };
  EXPECT_THAT(problem("0,1\n1,x\n"), ::testing::HasSubstr("bad.csv:2': 'x' is not a number"));
  EXPECT_THAT(problem("0,1\n1\n"), ::testing::HasSubstr("1 numbers, the lines before 2"));
  EXPECT_THAT(problem("0,nan\n1,1\n"), ::testing::HasSubstr("not a number"));
  EXPECT_THAT(problem("0,1\n"), ::testing::HasSubstr("at least 2 × 2"));
  EXPECT_THAT(problem(""), ::testing::HasSubstr("at least 2 × 2"));
  EXPECT_THAT(refusal([] { (void)load_heightmap("no/such.png"); }),
              ::testing::HasSubstr("no/such.png"));
  EXPECT_EQ(problem("0,1\n1,x\n").find('\n'), std::string::npos);
}

// 4 columns over 2 m are pixels of 0.5 m: the middle of the first is 0.6 + 0.25 m ahead. Row 0 is to the
// left. White is 0.2 m high.
TEST_F(Heightmaps, LieAheadWithTheirUpperEdgeToTheLeft) {
  const std::string path = text("m.csv", "0,0,1,0\n0,0,0,0\n0,0,0,0.5\n");
  const Terrain terrain(parse_terrain("heightmap:20cm,2m," + path), 1);
  EXPECT_EQ(terrain.surface(), Terrain::Surface::samples);
  EXPECT_NEAR(terrain.height_at(0.6 + 1.25, 0.5), 0.2, 0.02);
  EXPECT_NEAR(terrain.height_at(0.6 + 1.25, 0.25), 0.1, 0.01);
  EXPECT_NEAR(terrain.height_at(0.6 + 1.75, -0.5), 0.1, 0.01);
  EXPECT_NEAR(terrain.height_at(0.6 + 5.0, -3.0), 0.1, 1e-9) << "beyond its edges";
  EXPECT_EQ(terrain.height_at(0.0, 0.0), 0.0);
  EXPECT_EQ(terrain.highest(), 0.2);
  EXPECT_EQ(terrain.lowest(), 0.0);
}

TEST_F(Heightmaps, ArePartsOfSums) {
  const std::string path = text("m.csv", "1,1\n1,1\n");
  const TerrainSpec spec = parse_terrain("slope:10deg+heightmap:5cm,3," + path + "+waves:2cm");
  ASSERT_EQ(spec.parts.size(), 3U);
  EXPECT_EQ(spec.parts[1].file, path);
  EXPECT_EQ(parse_terrain(to_string(spec)), spec);
  const Terrain sum(spec, 1), rest(parse_terrain("slope:10deg+waves:2cm"), 1);
  EXPECT_NEAR(sum.height_at(2.0, 0.3) - rest.height_at(2.0, 0.3), 0.05, 1e-9);
}

TEST_F(Heightmaps, AreRefusedWithoutAFile) {
  for (const char* words : {"heightmap:20cm", "heightmap:20cm,4m", "heightmap:20cm,4m,"})
    EXPECT_THAT(refusal([&] { (void)parse_terrain(words); }),
                ::testing::HasSubstr("its length or its file is missing"))
        << words;
  EXPECT_THAT(refusal([] { (void)parse_terrain("heightmap:20cm,1cm,a.png"); }),
              ::testing::HasSubstr("the length must be 0.1 m or more"));
  EXPECT_THAT(refusal([] { (void)Terrain(parse_terrain("heightmap:1,1,none.csv"), 1); }),
              ::testing::HasSubstr("none.csv"));
}

}  // namespace
}  // namespace hexagait::sim3d
