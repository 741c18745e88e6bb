// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <filesystem>
#include <hexagait/urdf/detail/meshes.hpp>

namespace hexagait {
namespace {

constexpr std::uintmax_t kMaxBytes = 200'000'000;
constexpr int kMaxDepth = 64;  // of nodes
constexpr std::size_t kMaxVertices = 5'000'000;
constexpr double kFarthest = 1e6;  // [units of the file]

/// The vertices of a node and those below it.
void collect(const aiScene& scene, const aiNode& node, const aiMatrix4x4& above, int depth,
             std::vector<Vector3>& vertices) {
  const aiMatrix4x4 here = above * node.mTransformation;
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
    for (unsigned v = 0; v < mesh.mNumVertices && vertices.size() < kMaxVertices; ++v) {
      const aiVector3D p = here * mesh.mVertices[v];
      const Vector3 vertex(p.x, p.y, p.z);
      if (vertex.allFinite() && vertex.norm() < kFarthest) vertices.push_back(vertex);
    }
  }
  for (unsigned i = 0; i < node.mNumChildren && depth < kMaxDepth; ++i)
    collect(scene, *node.mChildren[i], here, depth + 1, vertices);
}

}  // namespace

std::vector<Vector3> read_mesh(const std::string& path, std::string& problem) {
  std::error_code error;
  if (std::filesystem::file_size(path, error) > kMaxBytes || error) {
    problem = "has more than " + std::to_string(kMaxBytes) + " bytes";
    return {};
  }
  Assimp::Importer importer;
  // Those who write URDFs mean the axes of the file, not the y upwards of Collada.
  importer.SetPropertyBool("IMPORT_COLLADA_IGNORE_UP_DIRECTION", true);
  const aiScene* scene = importer.ReadFile(path, 0);
  std::vector<Vector3> vertices;
  if (scene != nullptr && scene->mRootNode != nullptr)
    collect(*scene, *scene->mRootNode, aiMatrix4x4(), 0, vertices);
  if (vertices.empty()) problem = scene == nullptr ? importer.GetErrorString() : "has no vertices";
  return vertices;
}

}  // namespace hexagait
