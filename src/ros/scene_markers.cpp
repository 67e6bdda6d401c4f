// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/scene_markers.h"

#include <algorithm>
#include <optional>
#include <variant>

#include "smore/kinematics/urdf_model.h"

namespace smore {
namespace {

constexpr float kSceneOpacity = 0.35F;  // the maps are to be seen through the true shapes
constexpr double kLineWidth = 0.004;    // [m]
constexpr double kPathWidth = 0.01;     // [m]
constexpr double kTreeWidth = 0.001;    // [m]

std_msgs::ColorRGBA color(float red, float green, float blue, float alpha) {
  std_msgs::ColorRGBA result;
  result.r = red;
  result.g = green;
  result.b = blue;
  result.a = alpha;
  return result;
}

// Cyan for 0 to purple for 1, as the paper's figure 5 has it.
std_msgs::ColorRGBA riskColor(double risk) {
  const float share = static_cast<float>(std::clamp(risk, 0.0, 1.0));
  return color(0.6F * share, 1.0F - share, 1.0F - 0.2F * share, 1.0F);
}

geometry_msgs::Point toPoint(const Vec3& vector) {
  geometry_msgs::Point point;
  point.x = vector.x();
  point.y = vector.y();
  point.z = vector.z();
  return point;
}

geometry_msgs::Vector3 toScale(double x, double y, double z) {
  geometry_msgs::Vector3 scale;
  scale.x = x;
  scale.y = y;
  scale.z = z;
  return scale;
}

visualization_msgs::Marker makeMarker(const std::string& frame, const std::string& space, size_t id,
                                      int type) {
  visualization_msgs::Marker marker;
  marker.header.frame_id = frame;
  marker.ns = space;
  marker.id = static_cast<int>(id);
  marker.type = type;
  marker.action = visualization_msgs::Marker::ADD;
  marker.pose = toMessage(Pose::Identity());
  return marker;
}

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
  if (!visual.material) return color(0.6F, 0.6F, 0.6F, 1.0F);
  const urdf::Color& shade = visual.material->color;
  return color(shade.r, shade.g, shade.b, shade.a);
}

}  // namespace

visualization_msgs::MarkerArray sceneMarkers(const Scenario& scenario, const FrameNames& frames) {
  visualization_msgs::MarkerArray array;
  addShapes(scenario.environment, frames.world, "environment",
            color(0.45F, 0.45F, 0.5F, kSceneOpacity), &array);
  addShapes(scenario.object, frames.object, "object", color(0.25F, 0.45F, 0.9F, kSceneOpacity),
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
                                            double half_length, const FrameNames& frames) {
  visualization_msgs::MarkerArray array;
  visualization_msgs::Marker marker =
      makeMarker(frames.object, "lines", 0, visualization_msgs::Marker::LINE_LIST);
  marker.scale.x = kLineWidth;
  marker.color = color(0.9F, 0.5F, 0.1F, 0.5F);
  marker.frame_locked = true;
  for (const LineOfAction& line : lines) {
    marker.points.push_back(toPoint(line.point - half_length * line.direction));
    marker.points.push_back(toPoint(line.point + half_length * line.direction));
  }
  if (lines.empty()) marker.action = visualization_msgs::Marker::DELETE;
  array.markers.push_back(marker);
  return array;
}

visualization_msgs::MarkerArray pathMarkers(const Path& path, const std::vector<double>& risks,
                                            const std::string& frame) {
  visualization_msgs::MarkerArray array;
  visualization_msgs::Marker marker =
      makeMarker(frame, "path", 0, visualization_msgs::Marker::LINE_STRIP);
  marker.scale.x = kPathWidth;
  for (size_t i = 0; i < path.size(); ++i) {
    marker.points.push_back(toPoint(path[i].translation()));
    marker.colors.push_back(riskColor(risks.at(i)));
  }
  if (path.size() < 2) marker.action = visualization_msgs::Marker::DELETE;
  array.markers.push_back(marker);
  return array;
}

visualization_msgs::MarkerArray treeMarkers(const std::vector<TreeEdge>& tree,
                                            const std::string& frame) {
  visualization_msgs::MarkerArray array;
  visualization_msgs::Marker marker =
      makeMarker(frame, "tree", 0, visualization_msgs::Marker::LINE_LIST);
  marker.scale.x = kTreeWidth;
  marker.color = color(0.9F, 0.9F, 0.6F, 0.6F);
  for (const TreeEdge& edge : tree) {
    marker.points.push_back(toPoint(edge.from));
    marker.points.push_back(toPoint(edge.to));
  }
  if (tree.empty()) marker.action = visualization_msgs::Marker::DELETE;
  array.markers.push_back(marker);
  return array;
}

}  // namespace smore
