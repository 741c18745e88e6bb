// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>

#include <string>

namespace hexagait {

/// Computes the rotations of a model anew from the roll, pitch and yaw in its text. urdfdom computes
/// them by the C library's sine and cosine, whose last bits depend on the processor: see
/// trigonometry.hpp. Those of visual geometry, which is not used, are left as they are.
/// @param xml  the text that urdfdom has made this model of
void recompute_rotations(urdf::ModelInterface& model, const std::string& xml);

}  // namespace hexagait
