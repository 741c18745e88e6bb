// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace hexagait {

/// Where something stands in the file it was read from, from 1; 0: it was not read.
struct Mark {
  int line = 0;
  int column = 0;
};

}  // namespace hexagait
