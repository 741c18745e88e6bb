// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <dlfcn.h>

#include <cmath>
#include <hexagait/math/trigonometry.hpp>
#include <hexagait/sim2d/detail/box2d_trigonometry.hpp>

// In place of the C library's. Computed in double, they are rounded correctly but for one argument
// in a hundred million.
extern "C" {
float sinf(float x) noexcept { return static_cast<float>(hexagait::portable::sin(x)); }
float cosf(float x) noexcept { return static_cast<float>(hexagait::portable::cos(x)); }
void sincosf(float x, float* s, float* c) noexcept {
  const hexagait::portable::SinCos both = hexagait::portable::sincos(x);
  *s = static_cast<float>(both.s);
  *c = static_cast<float>(both.c);
}
float atan2f(float y, float x) noexcept {
  return static_cast<float>(hexagait::portable::atan2(y, x));
}
}

namespace hexagait::sim2d::detail {

void link_portable_trigonometry() noexcept {}

bool box2d_is_portable() noexcept {
  const auto is_ours = [](const char* name, auto* ours) {
    return dlsym(RTLD_DEFAULT, name) == reinterpret_cast<void*>(ours);
  };
  return is_ours("sinf", &::sinf) && is_ours("cosf", &::cosf) && is_ours("sincosf", &::sincosf) &&
         is_ours("atan2f", &::atan2f);
}

}  // namespace hexagait::sim2d::detail
