// SPDX-License-Identifier: BSD-3-Clause
#include "shape_reader.h"

#include "convex_parts.h"
#include "smore/common/result.h"
#include "smore/scenario/mesh.h"

namespace smore {
namespace {

// Anything a hand could hold or reach is far within these [m]; they catch millimetres taken for
// metres.
constexpr Range kSize{1e-4, 100.0};
constexpr Range kPosition{-100.0, 100.0};
constexpr Range kScale{-1e6, 1e6};

BoxShape readBox(ParameterReader* reader) {
  BoxShape box;
  reader->vector("size", &box.size, kSize);
  return box;
}

CylinderShape readCylinder(ParameterReader* reader) {
  CylinderShape cylinder;
  reader->number("radius", &cylinder.radius, kSize);
  reader->number("length", &cylinder.length, kSize);
  return cylinder;
}

SphereShape readSphere(ParameterReader* reader) {
  SphereShape sphere;
  reader->number("radius", &sphere.radius, kSize);
  return sphere;
}

MeshShape readMesh(ParameterReader* reader, const std::string& directory, bool moves) {
  std::string file;
  Vec3 scale = Vec3::Ones();
  reader->text("file", &file);
  if (reader->has("scale")) reader->vector("scale", &scale, kScale);
  if (file.empty()) return {};
  try {
    MeshShape mesh = loadMesh(file.front() == '/' ? file : directory + file, scale,
                              moves ? kLargestHeld : kLargestScene);
    if (moves && !servesAsHull(mesh)) decompose(&mesh);
    return mesh;
  } catch (const InputError& problem) {
    reader->error("file", problem.what());
    return {};
  }
}

}  // namespace

Pose readPose(ParameterReader* reader) {
  Vec3 position = Vec3::Zero();
  Vec3 rpy = Vec3::Zero();
  reader->vector("position", &position, kPosition);
  if (reader->has("rpy")) reader->angles("rpy", &rpy);
  return makePose(position, rpy);
}

std::vector<Shape> readShapes(ParameterReader* reader, const std::string& key,
                              const std::string& directory, bool moves) {
  std::vector<Shape> shapes;
  ParameterReader body = reader->nested(key);
  if (!reader->has(key)) return shapes;
  for (ParameterReader& entry : body.list("shapes")) {
    Shape shape;
    int type = -1;
    entry.choice("type", {"box", "cylinder", "sphere", "mesh"}, &type);
    if (type < 0) continue;
    if (type == 0) shape.geometry = readBox(&entry);
    if (type == 1) shape.geometry = readCylinder(&entry);
    if (type == 2) shape.geometry = readSphere(&entry);
    if (type == 3) shape.geometry = readMesh(&entry, directory, moves);
    shape.pose = readPose(&entry);
    entry.finishNested();
    shapes.push_back(shape);
  }
  body.finishNested();
  return shapes;
}

}  // namespace smore
