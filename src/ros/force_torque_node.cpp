// SPDX-License-Identifier: BSD-3-Clause
#include <geometry_msgs/WrenchStamped.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <deque>

#include "smore/contact/contact_sensing.h"
#include "smore/ros/names.h"
#include "smore/ros/parameter_source.h"
#include "smore/ros/tare_request.h"
#include "smore/ros/throttle.h"

namespace smore {
namespace {

constexpr double kWarningPeriod = 5.0;  // [s] between warnings of one kind
constexpr double kTimeJump = 1.0;       // [s]; stamps that fall by less are merely out of order

struct ForceTorqueParameters {
  FrameNames frames;
  double transform_timeout = 0.5;  ///< sample time that a wrench waits for its pose [s]
  double silence_timeout = 2.0;    ///< wall time without a wrench before a warning [s]
  double tare_timeout = 10.0;      ///< wall time that the tare service waits [s]
  ContactSensingParameters sensing;
};

void imposeScenario(const Scenario& scenario, YAML::Node parameters, ParameterReader* reader) {
  const auto impose = [&](const char* group, const char* key, double value) {
    imposeScenarioValue(parameters, group, key, value, reader);
  };
  impose("detector", "contact_force", scenario.contact_force);
  impose("detector", "free_force", scenario.free_force);
  impose("line", "force_stddev", scenario.wrench_noise.force_stddev);
  impose("line", "torque_stddev", scenario.wrench_noise.torque_stddev);
  impose("line", "added_direction_stddev", scenario.line_noise.direction);
  impose("line", "added_offset_stddev", scenario.line_noise.offset);
}

ForceTorqueParameters readParameters(const YAML::Node& mapping, const std::string& source) {
  ParameterReader reader(mapping, source);
  const std::optional<Scenario> scenario = readScenarioParameter(&reader);
  // After a scenario that cannot be read, its error is all there is to say.
  if (reader.has("scenario")) imposeScenario(scenario.value_or(Scenario()), mapping, &reader);
  ForceTorqueParameters parameters;
  parameters.frames = readFrameNames(&reader);
  reader.number("transform_timeout", &parameters.transform_timeout, {0.01, 60.0});
  reader.number("silence_timeout", &parameters.silence_timeout, {0.01, 3600.0});
  reader.number("tare_timeout", &parameters.tare_timeout, {0.1, 3600.0});
  parameters.sensing = readContactSensingParameters(&reader);
  reader.finish();
  return parameters;
}

/// Turns wrenches into contact observations. Wrenches and transforms arrive on one queue, handled
/// by the main thread; a wrench waits until the pose at its own stamp is known. Services have a
/// thread of their own, since they wait for the samples that the main thread handles.
class ForceTorqueNode {
 public:
  explicit ForceTorqueNode(const ForceTorqueParameters& parameters)
      : parameters_(parameters), sensing_(parameters.sensing) {
    node_.setCallbackQueue(&queue_);
    service_node_.setCallbackQueue(&service_queue_);
    const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
    tf_ = node_.subscribe(names::kTf, names::kStreamQueue, &ForceTorqueNode::onTransforms, this,
                          hints);
    tf_static_ = node_.subscribe(names::kTfStatic, names::kStreamQueue,
                                 &ForceTorqueNode::onStaticTransforms, this);
    contact_ =
        node_.advertise<smore_msgs::ContactObservation>(names::kContact, names::kObservationQueue);
    compensated_ = node_.advertise<geometry_msgs::WrenchStamped>(names::kWrenchCompensated,
                                                                 names::kStreamQueue);
    wrench_ = node_.subscribe(names::kWrench, names::kStreamQueue, &ForceTorqueNode::onWrench, this,
                              hints);
    tare_ = service_node_.advertiseService(names::kTare, &ForceTorqueNode::onTare, this);
    last_wrench_ = ros::WallTime::now();
  }

  void run() {
    ros::AsyncSpinner services(1, &service_queue_);
    services.start();
    const ros::WallDuration period(std::min(parameters_.silence_timeout, 0.1));
    while (ros::ok()) {
      queue_.callAvailable(period);
      processWaiting();
      checkSilence();
    }
  }

 private:
  void onWrench(const geometry_msgs::WrenchStamped& message) {
    last_wrench_ = ros::WallTime::now();
    if (wentBack(message.header.stamp, last_stamp_)) restart();
    last_stamp_ = message.header.stamp;
    waiting_.push_back(message);
  }

  void onTransforms(const tf2_msgs::TFMessage& message) {
    for (const geometry_msgs::TransformStamped& transform : message.transforms) {
      if (transform.child_frame_id == parameters_.frames.object) {
        if (wentBack(transform.header.stamp, last_pose_)) restart();
        last_pose_ = transform.header.stamp;
      }
      transforms_.setTransform(transform, names::kTf, false);
    }
  }

  void onStaticTransforms(const tf2_msgs::TFMessage& message) {
    for (const geometry_msgs::TransformStamped& transform : message.transforms) {
      transforms_.setTransform(transform, names::kTfStatic, true);
    }
  }

  static bool wentBack(const ros::Time& stamp, const ros::Time& last) {
    return stamp + ros::Duration(kTimeJump) < last;
  }

  /// After time went back: a recording begins again, or a simulator does.
  void restart() {
    ROS_WARN("time went back: forgetting wrenches and transforms, and taring anew");
    waiting_.clear();
    transforms_.clear();
    last_stamp_ = last_pose_ = ros::Time();
    sensing_ = ContactSensing(parameters_.sensing);
  }

  bool onTare(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response) {
    response.success = tare_request_.ask(parameters_.tare_timeout);
    response.message =
        response.success
            ? "tared"
            : "no tare within the timeout: check that wrenches and transforms arrive and that the "
              "robot stands still; the log says more";
    return true;
  }

  void processWaiting() {
    while (!waiting_.empty()) {
      std::string problem;
      const std::optional<WrenchSample> sample = sampleOf(waiting_.front(), &problem);
      if (sample) {
        process(*sample);
      } else if (!expired()) {
        return;
      } else {
        if (pose_warning_.isDue())
          ROS_WARN_STREAM("wrench dropped, its pose is not known: "
                          << problem << "; check that tf gives '" << parameters_.frames.object
                          << "' in '" << parameters_.frames.world << "' with the wrench's time");
      }
      waiting_.pop_front();
    }
  }

  /// Whether the first wrench waited too long, or too many wait.
  bool expired() const {
    const double waited = (waiting_.back().header.stamp - waiting_.front().header.stamp).toSec();
    return waited > parameters_.transform_timeout || waiting_.size() >= names::kStreamQueue;
  }

  std::optional<Pose> lookUp(const std::string& target, const std::string& source,
                             const ros::Time& stamp, std::string* problem) const {
    if (target == source) return Pose::Identity();
    if (!transforms_.canTransform(target, source, stamp, problem)) return std::nullopt;
    const Result<Pose> pose =
        fromTransform(transforms_.lookupTransform(target, source, stamp).transform);
    if (!pose) *problem = pose.reason();
    return pose ? std::optional<Pose>(*pose) : std::nullopt;
  }

  std::optional<WrenchSample> sampleOf(const geometry_msgs::WrenchStamped& message,
                                       std::string* problem) const {
    const ros::Time& stamp = message.header.stamp;
    const auto pose = lookUp(parameters_.frames.world, parameters_.frames.object, stamp, problem);
    if (!pose) return std::nullopt;
    const auto T_object_sensor =
        lookUp(parameters_.frames.object, message.header.frame_id, stamp, problem);
    if (!T_object_sensor) return std::nullopt;
    WrenchSample sample;
    sample.time = stamp.toSec();
    sample.wrench = transformWrench(*T_object_sensor, fromMessage(message.wrench));
    sample.T_world_object = *pose;
    return sample;
  }

  void process(const WrenchSample& sample) {
    if (tare_request_.take()) sensing_.startTare();
    const bool was_tared = sensing_.tared();
    const Result<ContactObservation> observation = sensing_.process(sample);
    if (!observation) {
      if (sample_warning_.isDue()) ROS_WARN_STREAM(observation.reason());
      publishUnsure(sample);
      return;
    }
    last_contact_ = observation->contact_id;
    contact_.publish(toMessage(*observation, parameters_.frames));
    publishCompensated(sample.time);
    reportTare(was_tared);
  }

  /// Each sample is answered, so that who waits for the answer goes on; this one says nothing.
  void publishUnsure(const WrenchSample& sample) {
    ContactObservation observation;
    observation.time = sample.time;
    observation.T_world_object = sample.T_world_object;
    observation.contact_id = last_contact_;
    contact_.publish(toMessage(observation, parameters_.frames));
  }

  void publishCompensated(double time) {
    if (!sensing_.tared() || compensated_.getNumSubscribers() == 0) return;
    geometry_msgs::WrenchStamped message;
    message.header.stamp.fromSec(time);
    message.header.frame_id = parameters_.frames.object;
    message.wrench = toMessage(sensing_.compensated());
    compensated_.publish(message);
  }

  void reportTare(bool was_tared) {
    if (sensing_.tared()) {
      if (!was_tared) ROS_INFO("tared");
      tare_request_.finish();
    } else if (!sensing_.tareProblem().empty()) {
      if (tare_warning_.isDue()) ROS_WARN_STREAM("tare refused: " << sensing_.tareProblem());
    }
  }

  void checkSilence() {
    if ((ros::WallTime::now() - last_wrench_).toSec() < parameters_.silence_timeout) return;
    if (silence_warning_.isDue())
      ROS_WARN_STREAM("no wrench on '" << node_.resolveName(names::kWrench) << "' for "
                                       << parameters_.silence_timeout
                                       << " s; is the sensor's driver running?");
  }

  ForceTorqueParameters parameters_;
  ContactSensing sensing_;
  TareRequest tare_request_;
  tf2::BufferCore transforms_;
  ros::CallbackQueue queue_;
  ros::CallbackQueue service_queue_;
  ros::NodeHandle node_;
  ros::NodeHandle service_node_{"~"};
  ros::Publisher contact_, compensated_;
  ros::Subscriber wrench_, tf_, tf_static_;
  ros::ServiceServer tare_;
  std::deque<geometry_msgs::WrenchStamped> waiting_;  ///< for their poses, oldest first
  ros::WallTime last_wrench_;
  ros::Time last_stamp_;  ///< of the newest wrench that came
  ros::Time last_pose_;   ///< of the newest pose that came
  Throttle pose_warning_{kWarningPeriod}, sample_warning_{kWarningPeriod};
  Throttle tare_warning_{kWarningPeriod}, silence_warning_{kWarningPeriod};
  int last_contact_ = 0;
};

void runForceTorque() {
  const ForceTorqueParameters parameters =
      readParameters(privateParameters(), ros::this_node::getName());
  ForceTorqueNode(parameters).run();
}

}  // namespace
}  // namespace smore

int main(int argc, char** argv) {
  return smore::runNode(argc, argv, "force_torque", smore::runForceTorque);
}
