// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/scene_markers.h"

#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "smore/kinematics/urdf_model.h"
#include "smore/ros/marker_parts.h"

namespace smore {
namespace {

constexpr float kSceneOpacity = 0.35F;  // the maps are to be seen through the true shapes
// Widths of lines, in voxels: thin beside the smallest that a map shows. Our choice.
constexpr double kLineWidth = 0.13;
constexpr double kPathWidth = 0.33;
constexpr double kTreeWidth = 0.03;

struct GeometryToMarker {
  visualization_msgs::Marker* marker;

  void operator()(const BoxShape& box) const {
    marker->type = visualization_msgs::Marker::CUBE;
    marker->scale = toScale(box.size.x(), box.size.y(), box.size.z());
  }
  void operator()(const CylinderShape& cylinder) const {
    marker->type = visualization_msgs::Marker::CYLINDER;
    marker->scale = toScale(2.0 * cylinder.radius, 2.0 * cylinder.radius, cylinder.length);
  }
  void operator()(const SphereShape& sphere) const {
    marker->type = visualization_msgs::Marker::SPHERE;
    marker->scale = toScale(2.0 * sphere.radius, 2.0 * sphere.radius, 2.0 * sphere.radius);
  }
  void operator()(const MeshShape& mesh) const {
    marker->type = visualization_msgs::Marker::TRIANGLE_LIST;
    marker->scale = toScale(1.0, 1.0, 1.0);
    for (const Eigen::Vector3i& triangle : mesh.triangles) {
      for (int corner = 0; corner < 3; ++corner) {
        marker->points.push_back(toPoint(mesh.vertices[triangle[corner]]));
      }
    }
  }
};

void addShapes(const std::vector<Shape>& shapes, const std::string& frame, const std::string& space,
               const std_msgs::ColorRGBA& shade, visualization_msgs::MarkerArray* array) {
  for (size_t i = 0; i < shapes.size(); ++i) {
    visualization_msgs::Marker marker =
        makeMarker(frame, space, i, visualization_msgs::Marker::CUBE);
    std::visit(GeometryToMarker{&marker}, shapes[i].geometry);
    marker.pose = toMessage(shapes[i].pose);
    marker.color = shade;
    marker.frame_locked = true;
    array->markers.push_back(marker);
  }
}

/// How far from the line it may lie, at `along` [m] from its nearest point to the origin: two
/// standard deviations [m].
double doubtAt(const LineOfAction& line, double along) {
  return 2.0 * std::hypot(line.offset_stddev, line.direction_stddev * along);
}

/// The skin of the doubt about one line: a tube that opens to both ends.
void addTube(const LineOfAction& line, double half_length, visualization_msgs::Marker* marker) {
  constexpr int kRings = 8;
  constexpr int kSides = 12;
  const Vec3 across = line.direction.unitOrthogonal();
  const Vec3 up = line.direction.cross(across);
  const auto at = [&](int ring, int side) {
    const double along = half_length * (2.0 * ring / kRings - 1.0);
    const double angle = 2.0 * M_PI * side / kSides;
    return toPoint(line.point + along * line.direction +
                   doubtAt(line, along) * (std::cos(angle) * across + std::sin(angle) * up));
  };
  for (int ring = 0; ring < kRings; ++ring) {
    for (int side = 0; side < kSides; ++side) {
      for (const auto& [r, s] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) {
        marker->points.push_back(at(ring + r, side + s));
      }
    }
  }
}

visualization_msgs::Marker doubtMarker(const std::vector<LineOfAction>& lines, double half_length,
                                       const std::string& frame) {
  visualization_msgs::Marker marker =
      makeMarker(frame, "uncertainty", 0, visualization_msgs::Marker::TRIANGLE_LIST);
  marker.scale = toScale(1.0, 1.0, 1.0);
  marker.color = makeColor(0.9F, 0.5F, 0.1F, 0.12F);
  marker.frame_locked = true;
  for (const LineOfAction& line : lines) {
    if (doubtAt(line, half_length) > 0.0) addTube(line, half_length, &marker);
  }
  if (marker.points.empty()) marker.action = visualization_msgs::Marker::DELETE;
  return marker;
}

std::optional<Shape> visualShape(const urdf::Visual& visual) {
  const Pose pose = toPose(visual.origin);
  switch (visual.geometry ? visual.geometry->type : urdf::Geometry::MESH) {
    case urdf::Geometry::BOX: {
      const auto& box = static_cast<const urdf::Box&>(*visual.geometry);
      return Shape{BoxShape{Vec3(box.dim.x, box.dim.y, box.dim.z)}, pose};
    }
    case urdf::Geometry::CYLINDER: {
      const auto& cylinder = static_cast<const urdf::Cylinder&>(*visual.geometry);
      return Shape{CylinderShape{cylinder.radius, cylinder.length}, pose};
    }
    case urdf::Geometry::SPHERE:
      return Shape{SphereShape{static_cast<const urdf::Sphere&>(*visual.geometry).radius}, pose};
    case urdf::Geometry::MESH:
      break;
  }
  return std::nullopt;
}

std_msgs::ColorRGBA colorOf(const urdf::Visual& visual) {
  if (!visual.material) return makeColor(0.6F, 0.6F, 0.6F, 1.0F);
  const urdf::Color& shade = visual.material->color;
  return makeColor(shade.r, shade.g, shade.b, shade.a);
}

}  // namespace

visualization_msgs::MarkerArray sceneMarkers(const Scenario& scenario, const FrameNames& frames) {
  visualization_msgs::MarkerArray array;
  addShapes(scenario.environment, frames.world, "environment",
            makeColor(0.45F, 0.45F, 0.5F, kSceneOpacity), &array);
  addShapes(scenario.object, frames.object, "object", makeColor(0.25F, 0.45F, 0.9F, kSceneOpacity),
            &array);
  return array;
}

visualization_msgs::MarkerArray robotMarkers(const urdf::ModelInterface& urdf) {
  visualization_msgs::MarkerArray array;
  for (const auto& [name, link] : urdf.links_) {
    for (const auto& visual : link->visual_array) {
      const std::optional<Shape> shape = visualShape(*visual);
      if (!shape) continue;
      const size_t id = array.markers.size();
      addShapes({*shape}, name, "robot", colorOf(*visual), &array);
      array.markers.back().id = static_cast<int>(id);
    }
  }
  return array;
}

visualization_msgs::MarkerArray lineMarkers(const std::vector<LineOfAction>& lines,
                                            double half_length, double voxel_size,
                                            const FrameNames& frames) {
  visualization_msgs::MarkerArray array;
  visualization_msgs::Marker marker =
      makeMarker(frames.object, "lines", 0, visualization_msgs::Marker::LINE_LIST);
  marker.scale.x = kLineWidth * voxel_size;
  marker.color = makeColor(0.9F, 0.5F, 0.1F, 0.5F);
  marker.frame_locked = true;
  for (const LineOfAction& line : lines) {
    marker.points.push_back(toPoint(line.point - half_length * line.direction));
    marker.points.push_back(toPoint(line.point + half_length * line.direction));
  }
  if (lines.empty()) marker.action = visualization_msgs::Marker::DELETE;
  array.markers.push_back(marker);
  array.markers.push_back(doubtMarker(lines, half_length, frames.object));
  return array;
}

visualization_msgs::MarkerArray pathMarkers(const Path& path, const std::vector<double>& risks,
                                            double voxel_size, const std::string& frame) {
  visualization_msgs::MarkerArray array;
  visualization_msgs::Marker marker =
      makeMarker(frame, "path", 0, visualization_msgs::Marker::LINE_STRIP);
  marker.scale.x = kPathWidth * voxel_size;
  for (size_t i = 0; i < path.size(); ++i) {
    marker.points.push_back(toPoint(path[i].translation()));
    marker.colors.push_back(riskColor(risks.at(i)));
  }
  if (path.size() < 2) marker.action = visualization_msgs::Marker::DELETE;
  array.markers.push_back(marker);
  return array;
}

visualization_msgs::MarkerArray treeMarkers(const std::vector<TreeEdge>& tree, double voxel_size,
                                            const std::string& frame) {
  visualization_msgs::MarkerArray array;
  visualization_msgs::Marker marker =
      makeMarker(frame, "tree", 0, visualization_msgs::Marker::LINE_LIST);
  marker.scale.x = kTreeWidth * voxel_size;
  marker.color = makeColor(0.9F, 0.9F, 0.6F, 0.6F);
  for (const TreeEdge& edge : tree) {
    marker.points.push_back(toPoint(edge.from));
    marker.points.push_back(toPoint(edge.to));
  }
  if (tree.empty()) marker.action = visualization_msgs::Marker::DELETE;
  array.markers.push_back(marker);
  return array;
}

}  // namespace smore
