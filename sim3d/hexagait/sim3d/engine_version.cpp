// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <dlfcn.h>
#include <ode/ode.h>

#include <filesystem>
#include <hexagait/sim3d/engine_version.hpp>

namespace hexagait::sim3d {

std::string engine_version() {
  // A shared ODE does not say its version; the name of its file does.
  Dl_info library{};
  std::error_code error;
  std::string file = "static";
  if (dladdr(reinterpret_cast<const void*>(&dGetConfiguration), &library) != 0 &&
      std::string(library.dli_fname).find(".so") != std::string::npos)
    file = std::filesystem::canonical(library.dli_fname, error).filename().string();
  return std::string(HEXAGAIT_ODE_VERSION) + " (" + file + ", " + dGetConfiguration() + ")";
}

}  // namespace hexagait::sim3d
