// SPDX-License-Identifier: BSD-3-Clause
#include "bag_evidence.h"

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <new>
#include <set>
#include <stdexcept>
#include <utility>

#include "other_task.h"
#include "sensing_replay.h"
#include "smore/contact/contact_numbering.h"
#include "smore/ros/evidence_log.h"
#include "smore/ros/names.h"
#include "smore/scenario/scenario_files.h"

namespace smore {
namespace {

/// The newest message of a type; nothing where there is none.
template <typename Message>
boost::shared_ptr<Message> newestOf(const rosbag::Bag& bag) {
  const std::string type = ros::message_traits::DataType<Message>::value();
  boost::shared_ptr<Message> newest;
  for (const rosbag::MessageInstance& message : rosbag::View(bag, rosbag::TypeQuery(type))) {
    newest = message.instantiate<Message>();
  }
  return newest;
}

class BagReader {
 public:
  BagReader(const std::string& file, const BagChoices& choices) : file_(file), choices_(choices) {
    bag_.open(file, rosbag::bagmode::Read);
    events_ = newestOf<smore_msgs::SensingEvents>(bag_);
    told_ = newestOf<smore_msgs::EvidenceSource>(bag_);
  }

  BagEvidence read() {
    result_.evidence.file = file_;
    result_.evidence.program = "a bag";
    result_.evidence.source = source();
    if (told_ && !told_->whole) warn("what was loaded or resumed is not in it");
    EvidenceLog log(spacingFor(result_.evidence.source.task));
    ContactNumbering numbering;
    SensingReplay replay(parameters(), events_ ? events_->events : noEvents(),
                         [&](ContactObservation observation) {
                           observation.contact_id = numbering.numberOf(observation.contact_id);
                           if (observation.time > since()) log.add(observation);
                         });
    feed(&replay);
    judge(replay);
    result_.evidence.observations = log.from(0);
    return std::move(result_);
  }

 private:
  static std::vector<smore_msgs::SensingEvent> noEvents() { return {}; }
  double since() const { return told_ ? told_->since.toSec() : 0.0; }
  [[noreturn]] void refuse(const std::string& problem) const {
    throw InputError(file_ + ": " + problem);
  }
  void warn(const std::string& problem) { result_.warnings.push_back(problem); }

  std::string scenarioFile() const {
    return findScenario(*choices_.scenario, shippedScenarioDirectory());
  }

  EvidenceSource source() const {
    EvidenceSource source;
    if (told_) source = readEvidenceSource(told_->records, file_, choices_.parameters);
    if (!told_ && !choices_.scenario) refuse("it does not say its task; give --scenario");
    if (choices_.parameters) source.parameters = *choices_.parameters;
    if (!choices_.scenario) return source;
    changeTask(*choices_.scenario, &source);
    return source;
  }

  ForceTorqueParameters parameters() const {
    if (events_) return readForceTorqueParameters(YAML::Load(events_->parameters), file_);
    if (!choices_.scenario) refuse("it does not say how it was sensed; give --scenario");
    YAML::Node defaults = YAML::LoadFile(shippedScenarioDirectory() + "/../force_torque.yaml");
    defaults["scenario"] = scenarioFile();
    return readForceTorqueParameters(defaults, file_);
  }

  std::string wrenchTopic() const {
    if (events_) return events_->wrench_topic;
    const std::string type = ros::message_traits::DataType<geometry_msgs::WrenchStamped>::value();
    std::set<std::string> topics;
    rosbag::View view(bag_, rosbag::TypeQuery(type));
    for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
      topics.insert(connection->topic);
    }
    if (topics.empty()) refuse("no wrenches (geometry_msgs/WrenchStamped) in it");
    if (topics.size() == 1) return *topics.begin();
    std::string names;
    for (const std::string& topic : topics) names += " " + topic;
    refuse("wrenches on more than one topic:" + names + "; leave one (rosbag filter)");
  }

  void feed(SensingReplay* replay) const {
    const std::string wrench = wrenchTopic();
    const std::vector<std::string> topics = {wrench, names::kTf, names::kTfStatic};
    for (const rosbag::MessageInstance& message : rosbag::View(bag_, rosbag::TopicQuery(topics))) {
      if (message.getTopic() == wrench) {
        if (const auto sample = message.instantiate<geometry_msgs::WrenchStamped>()) {
          replay->take(*sample);
        }
      } else if (const auto transforms = message.instantiate<tf2_msgs::TFMessage>()) {
        replay->take(*transforms, message.getTopic() == names::kTfStatic);
      }
    }
  }

  void judge(const SensingReplay& replay) {
    if (replay.begin().isZero()) {
      refuse("no wrench in it has a pose at its stamp; record " + wrenchTopic() +
             ", /tf and /tf_static together, and check the names of the frames");
    }
    if (!events_) {
      warn(
          "it does not say how it was sensed (topic sensing_events): it is tared at its beginning");
    } else if (!events_->events.empty() && replay.begin() != events_->events.front().stamp) {
      warn("it begins after the first wrench that was sensed: it is tared at its beginning");
    }
    if (!told_) warn("it does not say what the maps followed from (topic evidence_source)");
  }

  std::string file_;
  BagChoices choices_;
  rosbag::Bag bag_;
  smore_msgs::SensingEvents::Ptr events_;
  smore_msgs::EvidenceSource::Ptr told_;
  BagEvidence result_;
};

[[noreturn]] void refuse(const std::string& file, const std::exception& error) {
  throw InputError(file + ": no bag that can be read (" + error.what() +
                   "); rosbag reindex mends one that was cut");
}

}  // namespace

BagEvidence readBag(const std::string& file, const BagChoices& choices) {
  try {
    return BagReader(file, choices).read();
  } catch (const ros::Exception& error) {  // of rosbag, and of messages that do not end
    refuse(file, error);
  } catch (const std::bad_alloc& error) {  // a length that was damaged
    refuse(file, error);
  } catch (const std::length_error& error) {
    refuse(file, error);
  }
}

}  // namespace smore
