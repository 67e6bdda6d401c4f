// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_driver.h"

#include <map>

#include "smore/kinematics/arm_motion.h"
#include "smore/ros/robot_frames.h"
#include "smore/ros/scene_markers.h"

namespace smore {
namespace {

constexpr double kLinkPeriod = 0.04;  // [s] between the frames of the links
constexpr double kHalfSample = 0.001;

/// The Cartesian robot has no links: its hand is the object frame.
class CartesianDriver : public SimulatedDriver {
 public:
  explicit CartesianDriver(const FrameNames& frames) : frames_(frames) {}

  std::string sensorFrame() const override { return frames_.object; }
  Transforms fixedTransforms() const override { return {}; }
  Transforms controllerTransforms() const override { return {}; }

 private:
  visualization_msgs::MarkerArray linkMarkers() const override { return {}; }

  Transforms poseTransforms(const SimulatedRobot& robot, const ros::Time& stamp) const override {
    return {stampedTransform(frames_.world, frames_.object, robot.pose(), stamp)};
  }
  Transforms linkTransforms(const SimulatedRobot& /*robot*/,
                            const ros::Time& /*stamp*/) const override {
    return {};
  }

  FrameNames frames_;
};

/// Frames as ur_robot_driver and robot_state_publisher give them: the sensor's frame under the
/// controller's frame `base`, at each sample; links under base_link. An arm of another make has no
/// `base`: its sensor's frame is given under base_link.
class ArmDriver : public SimulatedDriver {
 public:
  ArmDriver(const Scenario& scenario, const FrameNames& frames, const UrdfModel& arm,
            const Vec3& tcp)
      : frames_(frames),
        T_world_base_link_(scenario.T_world_base),
        T_flange_tcp_(tcp),
        urdf_(arm),
        arm_(urdf_, armMotionParameters(scenario)),
        controller_(arm->getLink(kUrController) ? kUrController : names().base) {
    if (controller_ == names().base) return;
    const KinematicTree& tree = arm_.model().tree();
    T_base_base_link_ =
        arm_.model().linkPoses(JointVector::Zero())[tree.linkIndex(controller_)].inverse();
  }

  std::string sensorFrame() const override { return names().tool; }

  Transforms fixedTransforms() const override {
    Transforms transforms = controllerTransforms();
    transforms.push_back(baseTransform(arm_, T_world_base_link_, frames_));
    transforms.push_back(gripTransform(arm_, frames_));
    return transforms;
  }

  Transforms controllerTransforms() const override {
    if (controller_ == names().base) return {};
    return {stampedTransform(names().base, controller_, T_base_base_link_.inverse(), ros::Time())};
  }

 private:
  /// The frame that a controller of Universal Robots calls its base.
  static constexpr char kUrController[] = "base";

  visualization_msgs::MarkerArray linkMarkers() const override {
    return robotMarkers(*urdf_.model);
  }

  Transforms poseTransforms(const SimulatedRobot& robot, const ros::Time& stamp) const override {
    const Pose T_base_link_tool =
        arm_.model().toolPose(toJointVector(robot.jointPositions())) * T_flange_tcp_;
    return {
        stampedTransform(controller_, names().tool, T_base_base_link_ * T_base_link_tool, stamp)};
  }

  Transforms linkTransforms(const SimulatedRobot& robot, const ros::Time& stamp) const override {
    Transforms transforms;
    const std::vector<Pose> poses = arm_.model().tree().linkPoses(treePositions(robot));
    const std::vector<TreeLink>& links = arm_.model().tree().links();
    for (size_t i = 0; i < links.size(); ++i) {
      const std::string& link = links[i].name;
      if (link == names().base || link == names().tool || link == controller_) continue;
      transforms.push_back(stampedTransform(names().base, link, poses[i], stamp));
    }
    return transforms;
  }

  /// Positions of all joints of the description, the gripper's too.
  std::vector<double> treePositions(const SimulatedRobot& robot) const {
    std::map<std::string, double> known;
    const std::vector<std::string> joints = robot.jointNames();
    const std::vector<double> positions = robot.jointPositions();
    for (size_t i = 0; i < joints.size(); ++i) known[joints[i]] = positions[i];
    if (const auto gripper = robot.gripper()) known[gripper->joint] = gripper->position;
    std::vector<double> result;
    for (const std::string& joint : arm_.model().tree().jointNames()) {
      result.push_back(known[joint]);
    }
    return result;
  }

  const ArmFrames& names() const { return arm_.model().frames(); }

  FrameNames frames_;
  Pose T_world_base_link_;
  Eigen::Translation3d T_flange_tcp_;
  Pose T_base_base_link_ = Pose::Identity();  ///< from the controller's frame to base_link
  UrdfModel urdf_;
  ArmMotion arm_;
  std::string controller_;  ///< frame in which the driver gives the sensor's
};

}  // namespace

SimulatedDriver::Transforms SimulatedDriver::transformsAt(const SimulatedRobot& robot,
                                                          const ros::Time& stamp) {
  Transforms transforms = poseTransforms(robot, stamp);
  if ((stamp - last_links_).toSec() < kLinkPeriod - kHalfSample) return transforms;
  last_links_ = stamp;
  const Transforms links = linkTransforms(robot, stamp);
  transforms.insert(transforms.end(), links.begin(), links.end());
  return transforms;
}

visualization_msgs::MarkerArray SimulatedDriver::markersIn(const Scenario& scenario,
                                                           const FrameNames& frames) const {
  visualization_msgs::MarkerArray markers = sceneMarkers(scenario, frames);
  const visualization_msgs::MarkerArray links = linkMarkers();
  markers.markers.insert(markers.markers.end(), links.markers.begin(), links.markers.end());
  return markers;
}

std::unique_ptr<SimulatedDriver> makeSimulatedDriver(const Scenario& scenario,
                                                     const FrameNames& frames) {
  if (isArm(scenario.robot))
    return makeArmDriver(scenario, frames, armUrdf(scenario), Vec3::Zero());
  return std::make_unique<CartesianDriver>(frames);
}

std::unique_ptr<SimulatedDriver> makeArmDriver(const Scenario& scenario, const FrameNames& frames,
                                               const UrdfModel& arm, const Vec3& tcp) {
  return std::make_unique<ArmDriver>(scenario, frames, arm, tcp);
}

}  // namespace smore
