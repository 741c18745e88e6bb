// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

namespace hexagait::walk {

/// The last values of a stream, in a ring that is allocated once.
template <class Value>
class History {
 public:
  /// @param length  how many are kept, at least 1
  explicit History(std::size_t length) : values_(length) {}

  void push(const Value& value) {
    newest_ = (newest_ + 1) % values_.size();
    values_[newest_] = value;
    count_ = std::min(count_ + 1, values_.size());
  }

  [[nodiscard]] bool empty() const { return count_ == 0; }

  /// The newest is of age 0. Where there are not so many yet, the oldest one.
  /// @pre not empty
  [[nodiscard]] const Value& at(std::size_t age) const {
    assert(!empty());
    const std::size_t back = std::min(age, count_ - 1);
    return values_[(newest_ + values_.size() - back) % values_.size()];
  }

 private:
  std::vector<Value> values_;
  std::size_t newest_ = 0, count_ = 0;
};

}  // namespace hexagait::walk
