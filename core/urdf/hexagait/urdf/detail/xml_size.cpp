// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/urdf/detail/xml_size.hpp>

namespace hexagait {
namespace {

// What begins with `open` ends with `close`: comments and the like, whose content is not XML.
struct Section {
  std::string_view open, close;
};
constexpr Section kSections[] = {
    {"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}, {"<!", ">"}, {"</", ">"}};

// Just behind the next `text` from `at` on, or the end.
std::size_t behind(std::string_view xml, std::string_view text, std::size_t at) {
  const std::size_t found = xml.find(text, at);
  return found == xml.npos ? xml.size() : found + text.size();
}

struct Tag {
  std::size_t end = 0;  // just behind it
  std::size_t attributes = 0;
};

// The tag that begins at `at`: up to the next > that is not in quotation marks.
Tag tag_at(std::string_view xml, std::size_t at) {
  Tag tag;
  while (at < xml.size() && xml[at] != '>') {
    const bool quotes = xml[at] == '"' || xml[at] == '\'';
    if (quotes) ++tag.attributes;
    at = quotes ? behind(xml, xml.substr(at, 1), at + 1) : at + 1;
  }
  tag.end = std::min(at + 1, xml.size());
  return tag;
}

std::string at_line(std::string_view xml, std::size_t at, const std::string& problem) {
  const auto line =
      1 + std::count(xml.begin(), xml.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  return "line " + std::to_string(line) + ": " + problem;
}

}  // namespace

std::string too_large(std::string_view xml) {
  if (xml.size() > kMaxUrdfText)
    return "has " + std::to_string(xml.size()) + " bytes; at most " + std::to_string(kMaxUrdfText) +
           " are read";
  int depth = 0;
  std::size_t elements = 0, links = 0;
  for (std::size_t at = xml.find('<'); at < xml.size(); at = xml.find('<', at)) {
    const std::string_view rest = xml.substr(at);
    const auto begins = [&](const Section& section) { return rest.starts_with(section.open); };
    if (const auto* section = std::ranges::find_if(kSections, begins);
        section != std::end(kSections)) {
      if (section->open == "</") --depth;
      at = behind(xml, section->close, at + section->open.size());
      continue;
    }
    const auto [end, attributes] = tag_at(xml, at);
    const bool is_empty = end >= 2 && xml[end - 1] == '>' && xml[end - 2] == '/';
    // Links are children of the robot; what else has that name, as in a transmission, is none.
    if (depth == 1 && rest.starts_with("<link") && rest.find_first_of(" \t\r\n/>") == 5) ++links;
    if (depth >= kMaxUrdfDepth)
      return at_line(xml, at, "elements are nested deeper than " + std::to_string(kMaxUrdfDepth));
    if (++elements > kMaxUrdfElements)
      return at_line(xml, at, "has more than " + std::to_string(kMaxUrdfElements) + " elements");
    if (attributes > kMaxUrdfAttributes)
      return at_line(
          xml, at,
          "has an element of more than " + std::to_string(kMaxUrdfAttributes) + " attributes");
    if (links > kMaxUrdfLinks)
      return at_line(xml, at, "has more than " + std::to_string(kMaxUrdfLinks) + " links");
    if (!is_empty) ++depth;
    at = end;
  }
  return {};
}

}  // namespace hexagait
