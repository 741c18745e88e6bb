// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdarg>
#include <hexagait/sim3d/detail/ode.hpp>

namespace hexagait::sim3d::detail {
namespace {

thread_local long complaints = 0;

void count_complaint(int, const char*, va_list) { ++complaints; }

struct OdeLibrary {
  OdeLibrary() {
    dInitODE2(0);
    dSetMessageHandler(&count_complaint);
  }
  ~OdeLibrary() { dCloseODE(); }
};

}  // namespace

void initialise_ode() {
  static const OdeLibrary library;
  dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll));
}

long solver_complaints() { return complaints; }

}  // namespace hexagait::sim3d::detail
