// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hexagait/urdf/detail/urdf_file.hpp>
#include <map>

namespace hexagait {

/// The vertices of a mesh file: STL, OBJ, DAE and what else assimp reads [units of the file].
/// @param problem  set if it can't be read
[[nodiscard]] std::vector<Vector3> read_mesh(const std::string& path, std::string& problem);

/// The meshes of a URDF, each read once when it is asked for.
class Meshes {
 public:
  /// @param directory  of the URDF: where relative names begin; package://NAME/… is looked for in the
  ///                   directories above it and in `packages`
  Meshes(std::string directory, std::vector<std::string> packages)
      : directory_(std::move(directory)), packages_(std::move(packages)) {}

  /// Vertices in the frame of the shape [m]; none if the file can't be read.
  [[nodiscard]] std::vector<Vector3> vertices(const FileShape& mesh);

  /// What could not be read: of each name, why, and the first line that asks for it.
  struct Problem {
    int line = 0;
    std::string text;
  };
  [[nodiscard]] const std::map<std::string, Problem>& problems() const { return problems_; }

 private:
  [[nodiscard]] std::string find(const std::string& name) const;

  std::string directory_;
  std::vector<std::string> packages_;
  std::map<std::string, std::vector<Vector3>> read_;
  std::map<std::string, Problem> problems_;
};

}  // namespace hexagait
