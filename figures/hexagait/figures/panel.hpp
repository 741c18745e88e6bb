// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/math/geometry.hpp>

namespace hexagait::figures {

/// A panel's place in the sheet, in shares of its width and of its height with titles, from the
/// left and from below.
struct Panel {
  double left, right, bottom, top;
};

/// The part of a plane that a panel shows [m].
struct Box {
  Vector2 least = Vector2::Constant(1e9), greatest = Vector2::Constant(-1e9);

  void include(const Vector2& p) {
    least = least.cwiseMin(p);
    greatest = greatest.cwiseMax(p);
  }
  [[nodiscard]] Vector2 size() const { return greatest - least; }
  [[nodiscard]] Box grown(double room) const {
    return {least - Vector2::Constant(room), greatest + Vector2::Constant(room)};
  }
  /// Widened about its middle to the proportions of a panel in a sheet of width × height [px]: a
  /// metre is as long across as up.
  [[nodiscard]] Box fitted(const Panel& panel, int width, int height) const;
};

}  // namespace hexagait::figures
