// SPDX-License-Identifier: BSD-3-Clause
#include <geometry_msgs/WrenchStamped.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>

#include <deque>
#include <sstream>

#include "force_torque_parameters.h"
#include "smore/contact/sample_rate.h"
#include "smore/contact/still_poses.h"
#include "smore/ros/names.h"
#include "smore/ros/parameter_source.h"
#include "smore/ros/sensing_request.h"
#include "smore/ros/throttle.h"
#include "smore/ros/wrist_poses.h"

namespace smore {
namespace {

constexpr double kWarningPeriod = 5.0;  // [s] between warnings of one kind
constexpr double kFarRate = 1.5;   // times the period that parameters say, or below its inverse
constexpr double kTimeJump = 1.0;  // [s]; stamps that fall by less are merely out of order

std::string describe(const IdentifiedPayload& found) {
  std::ostringstream text;
  text << "the payload is " << found.payload.mass << " kg at ("
       << found.payload.center_of_mass_object.transpose() << ") m in the object frame; "
       << found.force_residual << " N and " << found.torque_residual << " N m are left over";
  return text.str();
}

/// Turns wrenches into contact observations. Wrenches and transforms arrive on one queue, handled
/// by the main thread; a wrench waits until the pose at its own stamp is known. Services have a
/// thread of their own, since they wait for the samples that the main thread handles.
class ForceTorqueNode {
 public:
  explicit ForceTorqueNode(const ForceTorqueParameters& parameters)
      : parameters_(parameters), sensing_(parameters.sensing), poses_(parameters.frames) {
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
    tare_ = serve(names::kTare, &tare_request_);
    identify_ = serve(names::kIdentifyPayload, &identify_request_);
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
    const ros::Time& stamp = message.header.stamp;
    if (wentBack(stamp, last_stamp_)) restart();
    if (stamp <= last_stamp_) {
      return warnOfDropped(message, "it is not newer than the one before; who else publishes?",
                           &repeated_warning_);
    }
    const std::string problem = frameNameProblem(message.header.frame_id);
    if (!problem.empty()) return warnOfDropped(message, problem, &frame_warning_);
    last_stamp_ = stamp;
    waiting_.push_back(message);
    watchRate(stamp.toSec());
  }

  void onTransforms(const tf2_msgs::TFMessage& message) {
    for (const geometry_msgs::TransformStamped& transform : message.transforms) {
      if (transform.child_frame_id != parameters_.frames.object) continue;
      if (wentBack(transform.header.stamp, last_pose_)) restart();
      last_pose_ = transform.header.stamp;
    }
    warnOfTransform(poses_.add(message, false));
  }

  void onStaticTransforms(const tf2_msgs::TFMessage& message) {
    warnOfTransform(poses_.add(message, true));
  }

  void warnOfTransform(const std::string& problem) {
    if (!problem.empty() && transform_warning_.isDue()) ROS_WARN_STREAM(problem);
  }

  void warnOfDropped(const geometry_msgs::WrenchStamped& message, const std::string& problem,
                     Throttle* warning) {
    if (warning->isDue())
      ROS_WARN_STREAM("wrench at " << message.header.stamp << " s dropped: " << problem);
  }

  void watchRate(double time) {
    rate_.add(time);
    const double told = parameters_.sensing.noise.sample_period;
    const double ratio = rate_.period().value_or(told) / told;
    const bool far = ratio > kFarRate || ratio < 1.0 / kFarRate;
    if (far && !rate_told_)
      ROS_WARN_STREAM("wrenches come every " << *rate_.period() << " s, noise/sample_period says "
                                             << told << " s; correct it there, or find out why");
    rate_told_ = far;
  }

  static bool wentBack(const ros::Time& stamp, const ros::Time& last) {
    return stamp + ros::Duration(kTimeJump) < last;
  }

  /// After time went back: a recording begins again, or a simulator does.
  void restart() {
    ROS_WARN("time went back: forgetting wrenches and transforms, and taring anew");
    waiting_.clear();
    poses_.clear();
    last_stamp_ = last_pose_ = ros::Time();
    rate_ = SampleRate();
    sensing_ = ContactSensing(parameters_.sensing);
    still_poses_.clear();
  }

  ros::ServiceServer serve(const std::string& name, SensingRequest* request) {
    using Trigger = std_srvs::Trigger;
    const boost::function<bool(Trigger::Request&, Trigger::Response&)> callback =
        [this, request](Trigger::Request& /*request*/, Trigger::Response& response) {
          const auto answer = request->ask(parameters_.tare_timeout);
          response.success = answer && answer->success;
          response.message =
              answer ? answer->message
                     : "no tare within the timeout: check that wrenches and transforms arrive and "
                       "that the robot stands still; the log says more";
          return true;
        };
    return service_node_.advertiseService(name, callback);
  }

  void processWaiting() {
    while (!waiting_.empty()) {
      const geometry_msgs::WrenchStamped& first = waiting_.front();
      const Result<WrenchSample> sample = poses_.sampleOf(first);
      if (sample) {
        process(*sample, first.header.stamp);
      } else if (!poses_.begunAfter(first.header.stamp, parameters_.transform_timeout)) {
        if (!expired()) return;
        warnOfDropped(first, sample.reason(), &pose_warning_);
      }
      waiting_.pop_front();
    }
  }

  /// Whether the first wrench waited too long, or too many wait.
  bool expired() const {
    const double waited = (waiting_.back().header.stamp - waiting_.front().header.stamp).toSec();
    return waited > parameters_.transform_timeout || waiting_.size() >= names::kStreamQueue;
  }

  void process(const WrenchSample& sample, const ros::Time& stamp) {
    if (tare_request_.take()) sensing_.startTare();
    if (identify_request_.take()) identify();
    const bool was_tared = sensing_.tared();
    const Result<ContactObservation> observation = sensing_.process(sample);
    if (!observation) {
      if (sample_warning_.isDue()) ROS_WARN_STREAM(observation.reason());
      return publishUnsure(sample, stamp);
    }
    last_contact_ = observation->contact_id;
    publish(*observation, stamp);
    publishCompensated(stamp);
    reportTare(was_tared);
    still_poses_.add(sample);
  }

  /// The stamp is the wrench's own: a time in seconds is not as fine.
  void publish(const ContactObservation& observation, const ros::Time& stamp) {
    smore_msgs::ContactObservation message = toMessage(observation, parameters_.frames);
    message.header.stamp = stamp;
    contact_.publish(message);
  }

  /// Where a payload is found, a tare begins, since the bias was that of another payload.
  void identify() {
    const Result<IdentifiedPayload> found = identifyPayload(still_poses_.poses());
    if (!found) return identify_request_.finish({false, found.reason()});
    payload_found_ = describe(*found);
    ROS_INFO_STREAM(payload_found_);
    parameters_.sensing.payload = found->payload;
    sensing_.setPayload(found->payload);
  }

  /// Each sample is answered, so that who waits for the answer goes on; this one says nothing.
  void publishUnsure(const WrenchSample& sample, const ros::Time& stamp) {
    ContactObservation observation;
    observation.time = sample.time;
    observation.T_world_object = sample.T_world_object;
    observation.contact_id = last_contact_;
    publish(observation, stamp);
  }

  void publishCompensated(const ros::Time& stamp) {
    if (!sensing_.tared() || compensated_.getNumSubscribers() == 0) return;
    geometry_msgs::WrenchStamped message;
    message.header.stamp = stamp;
    message.header.frame_id = parameters_.frames.object;
    message.wrench = toMessage(sensing_.compensated());
    compensated_.publish(message);
  }

  void reportTare(bool was_tared) {
    if (sensing_.tared()) {
      if (!was_tared) ROS_INFO("tared");
      tare_request_.finish({true, "tared"});
      identify_request_.finish({true, payload_found_});
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
  StillPoses still_poses_;
  std::string payload_found_;  ///< what was identified last; empty: nothing yet
  SensingRequest tare_request_, identify_request_;
  WristPoses poses_;
  SampleRate rate_;
  bool rate_told_ = false;
  ros::CallbackQueue queue_;
  ros::CallbackQueue service_queue_;
  ros::NodeHandle node_;
  ros::NodeHandle service_node_{"~"};
  ros::Publisher contact_, compensated_;
  ros::Subscriber wrench_, tf_, tf_static_;
  ros::ServiceServer tare_, identify_;
  std::deque<geometry_msgs::WrenchStamped> waiting_;  ///< for their poses, oldest first
  ros::WallTime last_wrench_;
  ros::Time last_stamp_;  ///< of the newest wrench that came
  ros::Time last_pose_;   ///< of the newest pose that came
  Throttle repeated_warning_{kWarningPeriod}, frame_warning_{kWarningPeriod};
  Throttle pose_warning_{kWarningPeriod}, transform_warning_{kWarningPeriod};
  Throttle sample_warning_{kWarningPeriod};
  Throttle tare_warning_{kWarningPeriod}, silence_warning_{kWarningPeriod};
  int last_contact_ = 0;
};

void runForceTorque() {
  const ForceTorqueParameters parameters =
      readForceTorqueParameters(privateParameters(), ros::this_node::getName());
  ForceTorqueNode(parameters).run();
}

}  // namespace
}  // namespace smore

int main(int argc, char** argv) {
  return smore::runNode(argc, argv, "force_torque", smore::runForceTorque);
}
