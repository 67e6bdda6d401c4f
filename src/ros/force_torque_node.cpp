// SPDX-License-Identifier: BSD-3-Clause
#include <geometry_msgs/WrenchStamped.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>

#include <memory>

#include "force_torque_parameters.h"
#include "payload_requests.h"
#include "sensing_events.h"
#include "sensing_record.h"
#include "smore/ros/belief_files.h"
#include "smore/ros/listener_status.h"
#include "smore/ros/names.h"
#include "smore/ros/parameter_source.h"
#include "smore/ros/throttle.h"
#include "tare_requests.h"
#include "wrench_intake.h"

namespace smore {
namespace {

constexpr double kWarningPeriod = 5.0;  // [s] between warnings of one kind

/// Turns wrenches into contact observations. Wrenches and transforms arrive on one queue, handled
/// by the main thread; a wrench waits until the pose at its own stamp is known. Services have a
/// thread of their own, since they wait for the samples that the main thread handles.
class ForceTorqueNode {
 public:
  /// `told`: all parameters, as `sensing_events` says them.
  ForceTorqueNode(const ForceTorqueParameters& parameters, const std::string& told)
      : parameters_(parameters),
        sensing_(parameters.sensing),
        payloads_(parameters.sensing.payload, parameters.axes),
        intake_(
            parameters, [this] { restart(); },
            [this](const WrenchSample& sample, const ros::Time& stamp) {
              process(sample, stamp);
            }) {
    node_.setCallbackQueue(&queue_);
    service_node_.setCallbackQueue(&service_queue_);
    const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
    tf_ = node_.subscribe(names::kTf, names::kStreamQueue, &ForceTorqueNode::onTransforms, this,
                          hints);
    tf_static_ = node_.subscribe(names::kTfStatic, names::kStreamQueue,
                                 &ForceTorqueNode::onStaticTransforms, this);
    events_ = node_.advertise<smore_msgs::SensingEvents>(names::kSensingEvents, names::kLatestQueue,
                                                         true);
    told_.parameters = told;
    told_.wrench_topic = node_.resolveName(names::kWrench);
    if (!parameters.record.empty()) beginRecord(belowRosHome(parameters.record));
    contact_ =
        node_.advertise<smore_msgs::ContactObservation>(names::kContact, names::kObservationQueue);
    compensated_ = node_.advertise<geometry_msgs::WrenchStamped>(names::kWrenchCompensated,
                                                                 names::kStreamQueue);
    wrench_ = node_.subscribe(names::kWrench, names::kStreamQueue, &ForceTorqueNode::onWrench, this,
                              hints);
    tare_ = serve(names::kTare, &tares_.tare());
    suspend_ = serve(names::kSuspend, &tares_.suspension());
    identify_ = serve(names::kIdentifyPayload, &payloads_.identification());
    forget_ = serve(names::kForgetPayload, &payloads_.forgetting());
    statuses_.add("wrench", [this](Status* status) {
      WrenchReport report = intake_.report();
      report.dropped.not_finite = refused_;
      wrench_status_.compose(report, status);
    });
    statuses_.add("sensor",
                  [this](Status* status) { sensor_status_.compose(sensorReport(), status); });
  }

  void run() {
    ros::AsyncSpinner services(1, &service_queue_);
    services.start();
    const ros::WallDuration period(std::min(parameters_.silence_timeout, 0.1));
    while (ros::ok()) {
      queue_.callAvailable(period);
      intake_.handOn();
      checkSilence();
      checkRecord();
      statuses_.publishIfDue();
    }
  }

 private:
  using Event = smore_msgs::SensingEvent;

  void beginRecord(const std::string& file) {
    record_ = std::make_unique<SensingRecord>(file);
    ROS_INFO_STREAM("recording what is sensed into " << file);
    for (const std::string& topic : recordedTopics()) record_->follow(topic, &node_);
  }

  void onWrench(const geometry_msgs::WrenchStamped& message) {
    if (record_) record_->add(told_.wrench_topic, message);
    intake_.onWrench(message);
  }
  void onTransforms(const tf2_msgs::TFMessage& message) {
    if (record_) record_->add(names::kTf, message);
    intake_.onTransforms(message);
  }
  void onStaticTransforms(const ros::MessageEvent<const tf2_msgs::TFMessage>& event) {
    const tf2_msgs::TFMessage& message = *event.getConstMessage();
    if (record_) record_->add(names::kTfStatic, message, event.getConnectionHeaderPtr());
    intake_.onStaticTransforms(message);
  }

  /// Tells all that happened so far: who comes late lacks nothing.
  void note(std::uint8_t kind, const ros::Time& stamp) {
    told_.events.push_back(sensingEvent(kind, stamp, sensing_.payload()));
    events_.publish(told_);
    if (record_) record_->add(events_.getTopic(), told_, latchingHeaderOf(told_));
  }

  /// After time went back.
  void restart() {
    note(Event::RESET, ros::Time());
    sensing_ = ContactSensing(parameters_.sensing);
    payloads_.forgetPoses();
    tares_.forget();
  }

  ros::ServiceServer serve(const std::string& name, SensingRequest* request) {
    using Trigger = std_srvs::Trigger;
    const boost::function<bool(Trigger::Request&, Trigger::Response&)> callback =
        [this, request](Trigger::Request& /*request*/, Trigger::Response& response) {
          const auto answer = request->ask(parameters_.tare_timeout);
          response.success = answer && answer->success;
          response.message =
              answer
                  ? answer->message
                  : "no answer within tare_timeout: check that wrenches and transforms arrive and "
                    "that the robot stands still; nothing is felt until a tare that has begun "
                    "comes to its end; the log says more";
          return true;
        };
    return service_node_.advertiseService(name, callback);
  }

  void process(const WrenchSample& sample, const ros::Time& stamp) {
    if (told_.events.empty()) note(Event::START, stamp);
    if (const auto kind = tares_.apply(sample.time, &sensing_)) noteBias(*kind, stamp);
    if (!tares_.suspended() && payloads_.apply(&sensing_)) {
      parameters_.sensing.payload = sensing_.payload();
      note(Event::PAYLOAD, stamp);
    }
    const bool was_tared = sensing_.tared();
    const Result<ContactObservation> observation = sensing_.process(sample);
    newest_ = sample.time;
    if (!observation) {
      ++refused_;
      if (sample_warning_.isDue()) ROS_WARN_STREAM(observation.reason());
      return publishUnsure(sample, stamp);
    }
    last_contact_ = observation->contact_id;
    publish(*observation, stamp);
    publishCompensated(stamp);
    reportTare(was_tared);
    reportResidual();
    reportLineless();
    payloads_.add(sample, observation->state, sensing_);
  }

  /// After a tare or before a zeroing: what was averaged for the payload is of another bias.
  void noteBias(std::uint8_t kind, const ros::Time& stamp) {
    note(kind, stamp);
    payloads_.forgetPoses();
  }

  void reportResidual() {
    if (const std::optional<Wrench>& residual = sensing_.newResidual())
      ROS_WARN_STREAM("the gripper keeps " << residual->force.norm() << " N ("
                                           << residual->force.transpose()
                                           << ") after the touch, felt where nothing touched "
                                              "before: taken into the bias");
  }

  void reportLineless() {
    if (!sensing_.endedWithoutLine()) return;
    ++lineless_;
    if (lineless_warning_.isDue())
      ROS_WARN_STREAM("a contact ended before its force had come to rest (line/settle, "
                      << parameters_.sensing.line.settle << " s), or was weaker than "
                      << "line/min_force: it gave no line of action; where that goes on, raise "
                      << "contact_force in the scenario, or lower object_mass of a simulated one");
  }

  /// The stamp is the wrench's own: a time in seconds is not as fine.
  void publish(const ContactObservation& observation, const ros::Time& stamp) {
    smore_msgs::ContactObservation message = toMessage(observation, parameters_.frames);
    message.header.stamp = stamp;
    contact_.publish(message);
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
    if (tares_.tareWaits()) return;
    if (sensing_.tared()) {
      if (!was_tared) ROS_INFO("tared");
      tares_.tare().finish({true, "tared"});
      payloads_.finish();
    } else if (!sensing_.tareProblem().empty()) {
      if (tare_warning_.isDue()) ROS_WARN_STREAM("tare refused: " << sensing_.tareProblem());
    }
  }

  SensorReport sensorReport() const {
    SensorReport report = reportOf(sensing_, parameters_.sensing.detector, newest_);
    report.range = parameters_.range;
    report.saturated = intake_.saturated();
    report.lineless = lineless_;
    return report;
  }

  void checkRecord() {
    if (!record_ || record_->problem().empty()) return;
    ROS_ERROR_STREAM("the record ends here: " << record_->problem() << "; check the disk");
    record_ = nullptr;
  }

  void checkSilence() {
    if (intake_.silence() < parameters_.silence_timeout) return;
    if (silence_warning_.isDue())
      ROS_WARN_STREAM("no wrench on '" << node_.resolveName(names::kWrench) << "' for "
                                       << parameters_.silence_timeout
                                       << " s; is the sensor's driver running?");
  }

  ForceTorqueParameters parameters_;
  ContactSensing sensing_;
  PayloadRequests payloads_;
  TareRequests tares_;
  WrenchIntake intake_;
  ros::CallbackQueue queue_;
  ros::CallbackQueue service_queue_;
  ros::NodeHandle node_;
  ros::NodeHandle service_node_{"~"};
  ros::Publisher contact_, compensated_, events_;
  smore_msgs::SensingEvents told_;
  std::unique_ptr<SensingRecord> record_;
  ros::Subscriber wrench_, tf_, tf_static_;
  ros::ServiceServer tare_, suspend_, identify_, forget_;
  Throttle sample_warning_{kWarningPeriod}, lineless_warning_{kWarningPeriod};
  Throttle tare_warning_{kWarningPeriod}, silence_warning_{kWarningPeriod};
  int last_contact_ = 0;
  double newest_ = 0.0;         ///< time of the last sample [s]
  std::uint64_t refused_ = 0;   ///< samples that were not finite, or whose times did not rise
  std::uint64_t lineless_ = 0;  ///< contacts that ended without a line
  WrenchStatus wrench_status_;
  SensorStatus sensor_status_;
  StatusPublisher statuses_;
};

void runForceTorque() {
  const YAML::Node told = privateParameters();
  const ForceTorqueParameters parameters =
      readForceTorqueParameters(told, ros::this_node::getName());
  ForceTorqueNode(parameters, toYaml(parameters, told)).run();
}

}  // namespace
}  // namespace smore

int main(int argc, char** argv) {
  return smore::runNode(argc, argv, "force_torque", smore::runForceTorque);
}
