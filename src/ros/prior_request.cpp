// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/prior_request.h"

#include <cstring>
#include <filesystem>

#include "smore/ros/names.h"

namespace smore {
namespace {

template <typename Vector>
Vec3 vectorOf(const Vector& message) {
  return {message.x, message.y, message.z};
}

MapSide sideOf(const std::string& map) {
  if (map == names::kObjectMap) return MapSide::kObject;
  if (map == names::kWorldMap) return MapSide::kWorld;
  throw InputError("map: '" + map + "' is none of world, object");
}

PriorFormat formatOf(const std::string& file) {
  if (!std::filesystem::path(file).is_absolute()) {
    throw InputError("file: '" + file + "' is not an absolute path; give one");
  }
  std::error_code problem;
  if (!std::filesystem::is_regular_file(file, problem)) {
    throw InputError("file: no file '" + file + "' where the mapping node runs; check the path");
  }
  const auto format = priorFormatOf(file);
  if (format) return *format;
  throw InputError("file: '" + file + "' is none of: " + kPriorFiles);
}

std::size_t offsetOf(const std::string& name, const sensor_msgs::PointCloud2& cloud) {
  for (const sensor_msgs::PointField& field : cloud.fields) {
    const bool is_number = field.datatype == sensor_msgs::PointField::FLOAT32;
    if (field.name != name || !is_number) continue;
    if (field.offset + sizeof(float) <= cloud.point_step) return field.offset;
  }
  throw InputError("cloud: no field " + name + " of type FLOAT32 in its points");
}

std::vector<Vec3> pointsOf(const sensor_msgs::PointCloud2& cloud) {
  const std::array<std::size_t, 3> offsets = {offsetOf("x", cloud), offsetOf("y", cloud),
                                              offsetOf("z", cloud)};
  const std::size_t row = std::size_t{cloud.width} * cloud.point_step;
  if (cloud.is_bigendian != 0 || cloud.row_step < row ||
      cloud.data.size() < std::size_t{cloud.height} * cloud.row_step) {
    throw InputError("cloud: big-endian, or fewer data than its width, height and steps say");
  }
  std::vector<Vec3> points;
  for (std::size_t v = 0; v < cloud.height; ++v) {
    for (std::size_t u = 0; u < cloud.width; ++u) {
      const std::uint8_t* at = &cloud.data[v * cloud.row_step + u * cloud.point_step];
      std::array<float, 3> point{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        std::memcpy(&point[axis], at + offsets[axis], sizeof(float));
      }
      const Vec3 place(point[0], point[1], point[2]);
      if (place.allFinite()) points.push_back(place);
    }
  }
  if (points.empty()) throw InputError("cloud: no point that is finite");
  return points;
}

bool isGiven(const geometry_msgs::Pose& pose) {
  const auto& turn = pose.orientation;
  return !vectorOf(pose.position).isZero(0.0) || turn.x != 0.0 || turn.y != 0.0 || turn.z != 0.0 ||
         turn.w != 0.0;
}

Pose givenPose(const geometry_msgs::Pose& message) {
  const Result<Pose> pose = fromMessage(message);
  if (!pose) throw InputError("pose: " + pose.reason());
  return *pose;
}

Pose poseByFrame(const std_msgs::Header& cloud, const std::string& frame,
                 const CloudPose& pose_of_cloud) {
  if (cloud.frame_id == frame) return Pose::Identity();
  const Result<Pose> pose = pose_of_cloud(frame, cloud);
  if (pose) return *pose;
  throw InputError("cloud: its frame_id is '" + cloud.frame_id + "', and tf does not give it in '" +
                   frame + "' (" + pose.reason() + "); publish it, or give the pose of '" +
                   cloud.frame_id + "' in '" + frame + "'");
}

Pose poseOf(const smore_msgs::InsertPrior::Request& request, const std::string& frame,
            const CloudPose& pose_of_cloud) {
  const bool has_cloud = !request.cloud.data.empty();
  Pose pose = Pose::Identity();
  if (isGiven(request.pose)) {
    pose = givenPose(request.pose);
  } else if (has_cloud) {
    pose = poseByFrame(request.cloud.header, frame, pose_of_cloud);
  }
  if (pose.translation().cwiseAbs().maxCoeff() <= kPriorPosition.max) return pose;
  throw InputError("pose: farther than 100 m from '" + frame + "'");
}

std::optional<Bounds> boxOf(const smore_msgs::InsertPrior::Request& request) {
  const Bounds box{vectorOf(request.min), vectorOf(request.max)};
  if (box.min.isZero(0.0) && box.max.isZero(0.0)) return std::nullopt;
  if (!(box.min.array() < box.max.array()).all() ||
      !(box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff() <= kPriorPosition.max)) {
    throw InputError("min: not below max on every axis, or farther than 100 m");
  }
  return box;
}

}  // namespace

PriorRequest readRequest(const smore_msgs::InsertPrior::Request& request, const FrameNames& frames,
                         const CloudPose& pose_of_cloud) {
  PriorRequest told;
  told.side = sideOf(request.map);
  PriorSource& source = told.source;
  const bool has_cloud = !request.cloud.data.empty();
  if (has_cloud == !request.file.empty()) throw InputError("give either a file or a cloud");
  source.box = boxOf(request);
  source.pose =
      poseOf(request, told.side == MapSide::kObject ? frames.object : frames.world, pose_of_cloud);
  if (has_cloud) {
    source.format = PriorFormat::kCloud;
    source.points = pointsOf(request.cloud);
  } else {
    source.format = formatOf(request.file);
    source.file = request.file;
  }
  const Vec3 scale = vectorOf(request.scale);
  if (!scale.isZero(0.0)) source.scale = scale;
  if (!source.scale.allFinite()) throw InputError("scale: not finite");
  if (request.confidence != 0.0) source.confidence = request.confidence;
  if (!(source.confidence >= kPriorConfidence.min && source.confidence <= kPriorConfidence.max)) {
    throw InputError("confidence: " + std::to_string(request.confidence) +
                     " is not from 0.001 to below 1");
  }
  return told;
}

}  // namespace smore
