// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <hexagait/figures/panel.hpp>

namespace hexagait::figures {

Box Box::fitted(const Panel& panel, int width, int height) const {
  const Vector2 pixels(width * (panel.right - panel.left), height * (panel.top - panel.bottom));
  const Vector2 half = 0.5 * size().cwiseQuotient(pixels).maxCoeff() * pixels;
  const Vector2 middle = 0.5 * (least + greatest);
  return {middle - half, middle + half};
}

}  // namespace hexagait::figures
