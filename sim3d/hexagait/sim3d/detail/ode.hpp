// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ode/ode.h>

#include <array>
#include <hexagait/math/geometry.hpp>
#include <memory>
#include <type_traits>

/// Ownership and conversions for ODE. Private to the module.
namespace hexagait::sim3d::detail {

template <auto destroy>
struct OdeDeleter {
  template <class T>
  void operator()(T* object) const {
    destroy(object);
  }
};

template <class Id, auto destroy>
using OdePtr = std::unique_ptr<std::remove_pointer_t<Id>, OdeDeleter<destroy>>;

using WorldPtr = OdePtr<dWorldID, dWorldDestroy>;
using GeomPtr = OdePtr<dGeomID, dGeomDestroy>;
using JointGroupPtr = OdePtr<dJointGroupID, dJointGroupDestroy>;
using HeightfieldDataPtr = OdePtr<dHeightfieldDataID, dGeomHeightfieldDataDestroy>;
using ThreadingPtr = OdePtr<dThreadingImplementationID, dThreadingFreeImplementation>;

/// Initialises ODE once per process and silences its output.
void initialise_ode();

/// Number of messages from ODE's constraint solver on this thread so far.
[[nodiscard]] long solver_complaints();

inline Vector3 from_ode(const dReal* v) { return {v[0], v[1], v[2]}; }

inline Matrix3 rotation_from_ode(const dReal* R) {
  return (Matrix3() << R[0], R[1], R[2], R[4], R[5], R[6], R[8], R[9], R[10]).finished();
}

/// ODE's 3 × 4 rotation matrix.
struct OdeRotation {
  explicit OdeRotation(const Matrix3& R)
      : m{R(0, 0), R(0, 1), R(0, 2), 0,       R(1, 0), R(1, 1),
          R(1, 2), 0,       R(2, 0), R(2, 1), R(2, 2), 0} {}
  std::array<dReal, 12> m;
};

}  // namespace hexagait::sim3d::detail
