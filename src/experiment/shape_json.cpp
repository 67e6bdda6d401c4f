// SPDX-License-Identifier: BSD-3-Clause
#include "shape_json.h"

#include <nlohmann/json.hpp>

namespace smore {
namespace {

const std::vector<std::string> kTypes = {"box", "cylinder", "sphere", "mesh"};  // as in the variant

constexpr Range kLength{1e-9, 1e9};  // [m]

Json geometryJson(const BoxShape& box) { return {{"size", toJson(box.size)}}; }

Json geometryJson(const CylinderShape& cylinder) {
  return {{"radius", cylinder.radius}, {"length", cylinder.length}};
}

Json geometryJson(const SphereShape& sphere) { return {{"radius", sphere.radius}}; }

Json geometryJson(const MeshShape& mesh) {
  Json vertices = Json::array();
  for (const Vec3& vertex : mesh.vertices) vertices.push_back(toJson(vertex));
  Json triangles = Json::array();
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    triangles.push_back({triangle.x(), triangle.y(), triangle.z()});
  }
  return {{"file", mesh.file}, {"vertices", vertices}, {"triangles", triangles}};
}

Eigen::Vector3i readTriangle(const JsonFields& fields, const Json& indices, std::size_t vertices) {
  Eigen::Vector3i triangle = Eigen::Vector3i::Zero();
  const bool is_triangle = indices.is_array() && indices.size() == 3;
  for (int i = 0; i < 3; ++i) {
    if (!is_triangle || !indices[i].is_number_unsigned() ||
        indices[i].get<std::uint64_t>() >= vertices) {
      fields.fail("triangles", "expected three indices of vertices each");
    }
    triangle[i] = indices[i].get<int>();
  }
  return triangle;
}

MeshShape readMesh(const JsonFields& fields) {
  MeshShape mesh;
  mesh.file = fields.text("file");
  mesh.vertices = fields.vectors("vertices");
  const Json& triangles = fields.raw("triangles");
  if (!triangles.is_array()) fields.fail("triangles", "expected a list");
  for (const Json& indices : triangles) {
    mesh.triangles.push_back(readTriangle(fields, indices, mesh.vertices.size()));
  }
  return mesh;
}

BoxShape readBox(const JsonFields& fields) {
  BoxShape box{fields.vector("size")};
  if ((box.size.array() <= 0.0).any()) fields.fail("size", "expected positive lengths");
  return box;
}

}  // namespace

Json toJson(const Shape& shape) {
  Json json{{"type", kTypes[shape.geometry.index()]}, {"pose", toJson(shape.pose)}};
  json.update(std::visit([](const auto& solid) { return geometryJson(solid); }, shape.geometry));
  return json;
}

Shape readShape(const JsonFields& fields) {
  Shape shape;
  shape.pose = fields.pose("pose");
  switch (fields.choice("type", kTypes)) {
    case 0:
      shape.geometry = readBox(fields);
      break;
    case 1:
      shape.geometry =
          CylinderShape{fields.number("radius", kLength), fields.number("length", kLength)};
      break;
    case 2:
      shape.geometry = SphereShape{fields.number("radius", kLength)};
      break;
    default:
      shape.geometry = readMesh(fields);
  }
  return shape;
}

}  // namespace smore
