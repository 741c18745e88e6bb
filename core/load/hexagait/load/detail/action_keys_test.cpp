// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <hexagait/load/detail/action_keys.hpp>
#include <hexagait/load/load_action.hpp>
#include <hexagait/text/text_file.hpp>
#include <map>
#include <set>
#include <sstream>
#include <testing/argos.hpp>
#include <testing/source_path.hpp>

namespace hexagait::action {
namespace {

// docs/actions.md as the user reads it: under each heading the first column of its table, and its
// YAML.
struct Section {
  std::set<std::string> keys;
  std::vector<std::string> examples;
};

std::map<std::string, Section> read_document() {
  std::map<std::string, Section> sections;
  std::istringstream text(read_text(testing::source_path("docs/actions.md"), kMaxYamlText));
  std::string line, heading;
  bool in_yaml = false;
  while (std::getline(text, line)) {
    Section& section = sections[heading];
    if (line == "```yaml") {
      in_yaml = true;
      section.examples.emplace_back();
    } else if (line == "```") {
      in_yaml = false;
    } else if (in_yaml) {
      section.examples.back() += line + "\n";
    } else if (line.starts_with("## ")) {
      heading = line.substr(3);
    } else if (line.starts_with("### ")) {
      heading = line.substr(4);
    } else if (line.starts_with("| `")) {
      section.keys.insert(line.substr(3, line.find('`', 3) - 3));
    }
  }
  return sections;
}

std::vector<YamlKeys> all_maps() {
  std::vector<YamlKeys> maps(std::begin(kCommands), std::end(kCommands));
  for (const YamlKeys* map : kMaps) maps.push_back(*map);
  return maps;
}

TEST(ActionKeys, AreThoseOfTheDocument) {
  std::map<std::string, Section> sections = read_document();
  for (const YamlKeys& map : all_maps()) {
    const std::set<std::string> keys(map.keys.begin(), map.keys.end());
    EXPECT_EQ(sections[std::string(map.of)].keys, keys) << map.of;
  }
}

// The other way round: no heading of the document is without its map. Frames and what all legs have
// are tables of other things.
TEST(ActionKeys, AreAllThatTheDocumentHas) {
  std::set<std::string> known = {"Legs, joints, frames", "Motions of a leg"};
  for (const YamlKeys& map : all_maps()) known.emplace(map.of);
  for (const auto& [heading, section] : read_document())
    if (!section.keys.empty()) {
      EXPECT_TRUE(known.contains(heading)) << heading;
    }
}

TEST(ActionKeys, AreAcceptedAsInTheExamplesOfTheDocument) {
  const RobotModel argos = testing::argos();
  ActionVocabulary vocabulary;
  vocabulary.custom_types = {"lamp"};
  std::string all;
  for (const auto& [heading, section] : read_document())
    for (const std::string& example : section.examples) {
      EXPECT_NO_THROW((void)parse_action(example, heading, argos, vocabulary)) << heading;
      all += example;
    }
  for (const YamlKeys& map : all_maps())
    for (const std::string_view key : map.keys)
      EXPECT_THAT(all, ::testing::HasSubstr(std::string(key) + ":")) << map.of;
}

// Each command is shown with all of its options, under its own heading.
TEST(ActionKeys, AreAllInTheExampleOfTheirCommand) {
  std::map<std::string, Section> sections = read_document();
  for (const YamlKeys& command : kCommands) {
    std::string all;
    for (const std::string& example : sections[std::string(command.of)].examples) all += example;
    for (const std::string_view key : command.keys)
      EXPECT_THAT(all, ::testing::HasSubstr(std::string(key) + ":")) << command.of;
  }
}

}  // namespace
}  // namespace hexagait::action
