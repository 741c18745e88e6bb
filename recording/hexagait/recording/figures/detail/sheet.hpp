// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Sizes that figures have in common [px].
namespace hexagait::recording::detail {

inline constexpr int kWidth = 1500, kHeight = 1000;

/// A sheet of many small pictures: so many in a row, below titles of this height.
inline constexpr int kColumns = 4, kTitles = 90;

}  // namespace hexagait::recording::detail
