// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <charconv>
#include <hexagait/text/invalid_input.hpp>
#include <hexagait/text/violations.hpp>

namespace hexagait {

void Violations::add(std::string_view element, std::string_view problem) {
  add(0, element, problem);
}

void Violations::add(int line, std::string_view element, std::string_view problem) {
  std::string text = source_;
  if (line > 0) text.append(":").append(std::to_string(line));
  text.append(": ").append(element).append(": ").append(problem);
  add_line(std::move(text));
}

void Violations::add(const Mark& mark, std::string_view problem) {
  std::string line = source_;
  line.append(":").append(std::to_string(mark.line));
  line.append(":").append(std::to_string(mark.column)).append(": ").append(problem);
  if (std::find(lines_.begin(), lines_.end(), line) == lines_.end()) add_line(std::move(line));
}

void Violations::add_line(std::string line) {
  lines_.push_back(std::move(line));
  if (lines_.size() < kMost) return;
  lines_.push_back(source_ + ": these are the first " + std::to_string(kMost) +
                   "; there may be more");
  throw_if_any();
}

void Violations::throw_if_any() const {
  if (empty()) return;
  std::string text;
  for (const std::string& line : lines_) text.append(text.empty() ? "" : "\n").append(line);
  throw InvalidInput(text);
}

std::string in_words(double value, int digits) {
  char text[32];
  // Not printf, whose decimal point is that of the locale.
  return {text,
          std::to_chars(text, text + sizeof(text), value, std::chars_format::general, digits).ptr};
}

}  // namespace hexagait
