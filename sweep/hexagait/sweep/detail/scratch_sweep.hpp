// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <hexagait/sweep/detail/journal.hpp>
#include <hexagait/sweep/results.hpp>
#include <hexagait/text/invalid_input.hpp>
#include <iterator>
#include <sstream>

namespace hexagait::sweep {

/// For tests: a directory for results, and a sweep that takes an instant.
class ScratchSweep : public testing::Test {
 protected:
  ScratchSweep() {
    std::string pattern = testing::TempDir() + "hexagait-sweep-XXXXXX";
    root_ = mkdtemp(pattern.data());
  }
  ~ScratchSweep() override { std::filesystem::remove_all(root_); }

  [[nodiscard]] std::filesystem::path at(const std::string& name) const { return root_ / name; }

  [[nodiscard]] static std::string content(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  [[nodiscard]] static std::vector<std::string> lines(const std::filesystem::path& file) {
    std::vector<std::string> result;
    std::istringstream stream(content(file));
    for (std::string line; std::getline(stream, line);) result.push_back(line);
    return result;
  }

  /// 3 controllers × 3 terrains × so many seeds.
  [[nodiscard]] static Sweep slices(std::uint64_t seeds, int slices = 50) {
    Sweep sweep;
    sweep.engine = Engine::slice;
    for (const char* name : {"tripod", "free", "wave:0.75"})
      sweep.controllers.push_back(*gait_state::parse_gait_choice(name));
    sweep.robots.push_back({.name = "six_feet", .model = {}});
    for (const char* name : {"flat", "descent:3-7", "profile:2"})
      sweep.terrains.push_back(ground(Engine::slice, name));
    sweep.num_seeds = seeds;
    sweep.limits.slices = slices;
    sweep.measure = columns(Engine::slice).front().name;
    return sweep;
  }

  /// Runs a shard to its end into a directory, and publishes it. @returns the bytes of trials.csv
  std::string run(const Sweep& sweep, const std::string& name, int jobs = 1, Shard shard = {}) {
    EXPECT_TRUE(run_shard(sweep, shard, at(name), {.jobs = jobs}).complete());
    publish(at(name));
    return content(at(name) / "trials.csv");
  }

  /// How often each trial is in a journal.
  [[nodiscard]] std::vector<std::string> journaled(const std::string& name) const {
    std::vector<std::string> positions;
    const std::vector<std::string> all = lines(journal_path(at(name)));
    for (std::size_t i = 1; i < all.size(); ++i)
      positions.push_back(all[i].substr(17, all[i].find(' ', 17) - 17));
    return positions;
  }

  [[nodiscard]] bool each_once(const std::string& name) const {
    std::vector<std::string> positions = journaled(name);
    std::ranges::sort(positions);
    return std::ranges::adjacent_find(positions) == positions.end();
  }

  /// What a call that must refuse says.
  template <class Call>
  [[nodiscard]] static std::string refusal(const Call& call) {
    try {
      call();
    } catch (const InvalidInput& error) {
      return error.what();
    }
    ADD_FAILURE() << "not refused";
    return "";
  }

 private:
  std::filesystem::path root_;
};

}  // namespace hexagait::sweep
