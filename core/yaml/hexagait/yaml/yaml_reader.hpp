// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <hexagait/math/geometry.hpp>
#include <hexagait/text/quantity.hpp>
#include <hexagait/text/violations.hpp>
#include <hexagait/yaml/yaml_tree.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hexagait {

/// The keys that a map of some kind may have.
struct YamlKeys {
  std::string_view of;  ///< what the map is, for people
  std::span<const std::string_view> keys;
};

/// A value that stands under a key, or in the list that does.
struct YamlField {
  std::string_view key;
  int node = 0;
  Mark mark;  ///< of the value; of the key if there is none
};

/// The keys and values of a map, all of known keys.
struct YamlFields {
  Mark mark;
  const YamlKeys* allowed = nullptr;
  std::vector<YamlField> fields;
};

/// What a number must be, as written for parse_quantity(). What is more than 0 is at least
/// kSmallestQuantity.
struct NumberRule {
  enum class Bound : std::uint8_t { any, not_negative, positive };
  Bound bound = Bound::any;
  Dimension dimension = Dimension::number;
  double most = kLargestQuantity;  ///< bound of the magnitude [SI units, radians]
};

/// Checked access to a YAML document. What is wrong is added to the violations with its place, and
/// reading goes on with the default, so that a user sees it all at once. After Violations::kMost, or
/// when references multiply the document beyond kMaxValues, it ends with InvalidInput.
class YamlReader {
 public:
  static constexpr std::size_t kMaxValues = 1'000'000;

  YamlReader(const YamlTree& tree, Violations& violations) : tree_(tree), violations_(violations) {}

  [[nodiscard]] const YamlTree& tree() const { return tree_; }
  [[nodiscard]] const YamlNode& node(int index) const {
    return tree_[static_cast<std::size_t>(index)];
  }

  /// How much has been refused up to now.
  [[nodiscard]] std::size_t num_refused() const { return num_refused_; }

  void refuse(const Mark& mark, std::string_view problem);
  /// Refuses it and reads no further. @throws InvalidInput  with everything refused so far
  [[noreturn]] void stop(const Mark& mark, std::string_view problem);
  /// Refuses `found`: `key: is "found"; it must be …`.
  void refuse(const YamlField& field, std::string_view must_be);
  /// Refuses a word and names the one that was probably meant, or all that there are.
  void refuse_word(const Mark& mark, std::string_view what, std::string_view word,
                   std::span<const std::string> known);

  /// The fields of a map, or of given keys and values; unknown keys are refused.
  [[nodiscard]] YamlFields fields(const YamlField& map, const YamlKeys& allowed);
  [[nodiscard]] YamlFields fields(const Mark& mark, std::span<const int> keys_and_values,
                                  const YamlKeys& allowed);

  [[nodiscard]] std::optional<YamlField> find(const YamlFields& fields, std::string_view key) const;
  /// The same; refused if it is missing.
  [[nodiscard]] std::optional<YamlField> require(const YamlFields& fields, std::string_view key);

  /// The values of a list; refused and empty if it is none.
  [[nodiscard]] std::vector<YamlField> list(const YamlField& field);
  [[nodiscard]] std::optional<std::string> text(const YamlField& field);
  [[nodiscard]] std::optional<double> number(const YamlField& field, NumberRule rule);
  /// As many numbers as asked for; refused and none if they are not.
  [[nodiscard]] std::optional<std::vector<double>> numbers(const YamlField& field,
                                                           std::span<const std::size_t> counts,
                                                           NumberRule rule);
  [[nodiscard]] std::optional<Vector3> vector(const YamlField& field, NumberRule rule = {});
  /// The index of a word among those known.
  [[nodiscard]] std::optional<std::size_t> word(const YamlField& field,
                                                std::span<const std::string> known);

  // With a default for what is not there, or not right.
  [[nodiscard]] double number_or(const YamlFields& fields, std::string_view key, double otherwise,
                                 NumberRule rule);
  [[nodiscard]] bool flag_or(const YamlFields& fields, std::string_view key, bool otherwise);
  [[nodiscard]] Vector3 vector_or(const YamlFields& fields, std::string_view key,
                                  const Vector3& otherwise, NumberRule rule = {});

  /// Counts values that were read; throws if there are too many.
  void count(std::size_t values);

 private:
  const YamlTree& tree_;
  Violations& violations_;
  std::size_t count_ = 0, num_refused_ = 0;
};

/// A value as messages show it: "text", a list, a map, nothing.
[[nodiscard]] std::string in_words(const YamlNode& node);

/// The beginning of a text in quotation marks, without characters that are no letters.
[[nodiscard]] std::string in_quotes(std::string_view text);

}  // namespace hexagait
