// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <hexagait/urdf/detail/meshes.hpp>

namespace hexagait {
namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

}  // namespace

/// The path of a mesh, or nothing.
std::string Meshes::find(const std::string& name) const {
  constexpr std::string_view kPackage = "package://", kModel = "model://", kFile = "file://";
  if (name.starts_with(kFile)) return is_file(name.substr(kFile.size())) ? name.substr(7) : "";
  const bool in_package = name.starts_with(kPackage) || name.starts_with(kModel);
  if (!in_package) {
    const fs::path path = fs::path(directory_) / name;
    return is_file(path) ? path.string() : "";
  }
  const fs::path inside = name.substr(name.find("://") + 3);
  const fs::path without_package = inside.lexically_relative(*inside.begin());
  std::vector<fs::path> places(packages_.begin(), packages_.end());
  std::error_code error;
  for (fs::path above = fs::absolute(directory_.empty() ? "." : directory_, error);
       above.has_relative_path(); above = above.parent_path())
    places.push_back(above);
  for (const fs::path& place : places)
    for (const fs::path& path : {place / inside, place / without_package})
      if (is_file(path)) return path.string();
  return "";
}

std::vector<Vector3> Meshes::vertices(const FileShape& mesh) {
  const auto [entry, is_new] = read_.try_emplace(mesh.mesh);
  if (is_new) {
    const std::string path = find(mesh.mesh);
    std::string problem;
    if (path.empty())
      problem = "is not on this machine";
    else
      entry->second = read_mesh(path, problem);
    if (!problem.empty()) problems_[mesh.mesh] = {mesh.line, problem};
  }
  std::vector<Vector3> scaled = entry->second;
  for (Vector3& vertex : scaled) vertex = vertex.cwiseProduct(mesh.size);
  return scaled;
}

}  // namespace hexagait
