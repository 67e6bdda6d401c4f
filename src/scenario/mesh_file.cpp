// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_file.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <filesystem>
#include <set>

#include "smore/common/result.h"

namespace smore {
namespace {

// All that could keep two vertices at one place apart, or solids of one file in several pieces.
constexpr int kIgnored = aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS |
                         aiComponent_COLORS | aiComponent_TEXCOORDS | aiComponent_BONEWEIGHTS |
                         aiComponent_TEXTURES | aiComponent_MATERIALS;

constexpr unsigned kRepairs = aiProcess_RemoveComponent | aiProcess_Triangulate |
                              aiProcess_PreTransformVertices | aiProcess_JoinIdenticalVertices |
                              aiProcess_FindDegenerates | aiProcess_SortByPType;

void configure(Assimp::Importer* importer) {
  importer->SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, kIgnored);
  importer->SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                               aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  importer->SetPropertyBool(AI_CONFIG_PP_FD_REMOVE, true);
  // By their area, triangles of a millimetre in metres would go too and leave holes.
  importer->SetPropertyBool(AI_CONFIG_PP_FD_CHECKAREA, false);
  importer->SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
}

void checkKind(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char letter) { return std::tolower(letter); });
  const std::set<std::string> known = {".stl", ".obj", ".ply", ".dae"};
  if (known.count(extension) == 0) {
    throw InputError(file + ": not a mesh of a known kind; export it as STL, OBJ, PLY or DAE");
  }
  if (!std::filesystem::is_regular_file(file)) {
    throw InputError(file + ": there is no such file; check the path (relative to the scenario)");
  }
}

// The repairs look vertices up by these without asking.
void checkFaces(const aiMesh& part, const std::string& file) {
  for (unsigned i = 0; i < part.mNumFaces; ++i) {
    const aiFace& face = part.mFaces[i];
    for (unsigned k = 0; k < face.mNumIndices; ++k) {
      if (face.mIndices[k] < part.mNumVertices) continue;
      throw InputError(
          file +
          ": a face has a vertex that is not there; export the mesh anew, a PLY as ascii: of a "
          "binary one a first byte that looks like a line end is left out");
    }
  }
}

void append(const aiMesh& part, MeshFile* mesh) {
  const auto first = static_cast<int>(mesh->vertices.size());
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    const aiVector3D& vertex = part.mVertices[i];
    mesh->vertices.emplace_back(vertex.x, vertex.y, vertex.z);
  }
  for (unsigned i = 0; i < part.mNumFaces; ++i) {
    const aiFace& face = part.mFaces[i];
    mesh->triangles.emplace_back(first + static_cast<int>(face.mIndices[0]),
                                 first + static_cast<int>(face.mIndices[1]),
                                 first + static_cast<int>(face.mIndices[2]));
  }
}

}  // namespace

MeshFile readMeshFile(const std::string& file) {
  checkKind(file);
  Assimp::Importer importer;
  configure(&importer);
  const aiScene* scene = importer.ReadFile(file, 0);
  for (unsigned i = 0; scene != nullptr && i < scene->mNumMeshes; ++i) {
    checkFaces(*scene->mMeshes[i], file);
  }
  if (scene != nullptr) scene = importer.ApplyPostProcessing(kRepairs);
  if (scene == nullptr) {
    throw InputError(file + ": cannot be read as a mesh (" + importer.GetErrorString() +
                     "); export it anew");
  }
  MeshFile mesh;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) append(*scene->mMeshes[i], &mesh);
  return mesh;
}

}  // namespace smore
