// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace hexagait::sim2d::detail {

/// Makes Box2D turn its bodies by portable::sincos and portable::atan2.
///
/// Box2D calls the C library's sinf, cosf, sincosf and atan2f, whose last bits may depend on the
/// processor. The source of this function defines these four as well: the linker gives them to all
/// of a program that is linked to this library, Box2D included. (Not so if the library is part of a
/// module that a program loads by dlopen(): then Box2D keeps those of the C library, and walks may
/// differ in their last bits between unlike processors.)
void link_portable_trigonometry() noexcept;

/// Are those four in force for shared libraries, Box2D among them?
[[nodiscard]] bool box2d_is_portable() noexcept;

}  // namespace hexagait::sim2d::detail
