// SPDX-License-Identifier: BSD-3-Clause
#include "smore/scenario/scenario_json.h"

#include <nlohmann/json.hpp>

#include "smore/common/json_fields.h"
#include "smore/scenario/tessellation.h"
#include "triangle_tree.h"

namespace smore {
namespace {

Json poseJson(const Pose& pose) {
  return {{"position", toJson(Vec3(pose.translation()))}, {"rpy", toJson(rollPitchYaw(pose))}};
}

struct GeometryToJson {
  Json operator()(const BoxShape& box) const {
    return {{"type", "box"}, {"size", toJson(box.size)}};
  }
  Json operator()(const CylinderShape& cylinder) const {
    return {{"type", "cylinder"}, {"radius", cylinder.radius}, {"length", cylinder.length}};
  }
  Json operator()(const SphereShape& sphere) const {
    return {{"type", "sphere"}, {"radius", sphere.radius}};
  }
  Json operator()(const MeshShape& mesh) const {
    return {{"type", "mesh"},
            {"file", mesh.file},
            {"scale", toJson(mesh.scale)},
            {"convex_parts", mesh.parts.size()},
            {"parts_error", mesh.parts_error}};
  }
};

Json trianglesJson(const MeshShape& surface) {
  Json list = Json::array();
  for (const Eigen::Vector3i& triangle : surface.triangles) {
    Json corners = Json::array();
    for (const Vec3& corner : cornersOf(surface, triangle)) corners.push_back(toJson(corner));
    list.push_back(std::move(corners));
  }
  return list;
}

Json bodyJson(const std::vector<Shape>& shapes) {
  Json list = Json::array();
  for (const Shape& shape : shapes) {
    Json json = std::visit(GeometryToJson(), shape.geometry);
    json.update(poseJson(shape.pose));
    json["triangles"] = trianglesJson(tessellate(shape));
    list.push_back(std::move(json));
  }
  return {{"shapes", std::move(list)}};
}

std::string formatName(PriorFormat format) {
  switch (format) {
    case PriorFormat::kTruth:
      return "truth";
    case PriorFormat::kMesh:
      return "mesh";
    case PriorFormat::kCloud:
      return "cloud";
    case PriorFormat::kOctree:
      return "octree";
  }
  return "unknown";
}

Json priorJson(const std::vector<PriorSource>& entries) {
  Json list = Json::array();
  for (const PriorSource& entry : entries) {
    Json json = poseJson(entry.pose);
    json["source"] = entry.format == PriorFormat::kTruth ? "truth" : entry.file;
    json["format"] = formatName(entry.format);
    json["scale"] = toJson(entry.scale);
    json["offset"] = toJson(entry.offset);
    json["confidence"] = entry.confidence;
    if (entry.box) {
      json["min"] = toJson(entry.box->min);
      json["max"] = toJson(entry.box->max);
    }
    list.push_back(std::move(json));
  }
  return list;
}

Json noiseJson(const WrenchNoise& noise) {
  return {{"force_stddev", noise.force_stddev},
          {"torque_stddev", noise.torque_stddev},
          {"force_bias", toJson(noise.force_bias)},
          {"torque_bias", toJson(noise.torque_bias)},
          {"force_drift", noise.force_drift}};
}

}  // namespace

std::string toJson(const Scenario& s) {
  Json json{
      {"name", s.name},
      {"task", s.task == Task::kRetrieve ? "retrieve" : "reconstruct"},
      {"voxel_size", s.voxel_size},
      {"motion", s.motion == Motion::kPlanar ? "planar" : "spatial"},
      {"robot", robotText(s)},
      {"start", poseJson(s.start)},
      {"goal", poseJson(s.goal)},
      {"workspace", {{"min", toJson(s.workspace.min)}, {"max", toJson(s.workspace.max)}}},
      {"goal_tolerance",
       {{"position", s.goal_position_tolerance}, {"angle", s.goal_angle_tolerance}}},
      {"friction", s.friction},
      {"speed", {{"linear", s.linear_speed}, {"angular", s.angular_speed}}},
      {"contact_force", s.contact_force},
      {"free_force", s.free_force},
      {"wrench_noise", noiseJson(s.wrench_noise)},
      {"line_noise", {{"direction", s.line_noise.direction}, {"offset", s.line_noise.offset}}},
      {"on_contact", s.on_contact == OnContact::kReset ? "reset" : "retreat"},
      {"reconstruct", {{"touches", s.reconstruct_touches}}},
      {"perturb", {{"position", s.perturb.position}, {"angle", s.perturb.angle}}},
      {"object_mass", s.object_mass},
      {"robot_base", poseJson(s.T_world_base)},
      {"gripper_object", poseJson(s.T_gripper_object)},
      {"prior", {{"object", priorJson(s.prior.object)}, {"world", priorJson(s.prior.world)}}}};
  if (s.hasScene()) {
    json["object"] = bodyJson(s.object);
    json["environment"] = bodyJson(s.environment);
  }
  constexpr int kOneLine = -1;
  return json.dump(kOneLine, ' ', false, Json::error_handler_t::replace);
}

}  // namespace smore
