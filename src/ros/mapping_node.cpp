// SPDX-License-Identifier: BSD-3-Clause
#include <octomap_msgs/GetOctomap.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include "cloud_frames.h"
#include "display_settings.h"
#include "keeper_start.h"
#include "mapping_parameters.h"
#include "smore/mapping/prior_maps.h"
#include "smore/ros/belief_display.h"
#include "smore/ros/belief_files.h"
#include "smore/ros/evidence_messages.h"
#include "smore/ros/map_publisher.h"
#include "smore/ros/mapping_status.h"
#include "smore/ros/names.h"
#include "smore/ros/parameter_source.h"
#include "smore/ros/prior_request.h"
#include "smore/ros/throttle.h"
#include "twin_maps_service.h"

namespace smore {
namespace {

constexpr double kWarningPeriod = 5.0;  // [s] between warnings of one kind
constexpr int kServiceThreads = 3;      // two calls that take long and the publisher

ros::Time timeOf(double stamp) {
  ros::Time time;
  return time.fromSec(stamp);
}

/// Observations come in on the main thread and are handed to the keeper; services and publishing
/// have threads of their own, since they wait for it. Callers of `twin_maps` have others, since
/// they wait for what is still to come.
class MappingNode {
 public:
  MappingNode(const MappingParameters& parameters, const EvidenceSource& source)
      : parameters_(parameters),
        source_(source),
        space_(source.task.motionSpace()),
        files_(belowRosHome(parameters.beliefs), source),
        keeper_(startKeeper(parameters, source, files_)),
        service_node_(makeServiceNode()),
        display_(parameters),
        belief_(service_node_, parameters.frames, source.task.voxel_size),
        world_(service_node_, names::kWorldMap, parameters.frames.world, worldColors(),
               parameters.display_min_probability),
        object_(service_node_, names::kObjectMap, parameters.frames.object, objectColors(),
                parameters.display_min_probability) {
    contact_ = node_.subscribe(names::kContact, names::kObservationQueue, &MappingNode::onContact,
                               this, ros::TransportHints().tcpNoDelay());
    source_told_ = service_node_.advertise<smore_msgs::EvidenceSource>(names::kEvidenceSource,
                                                                       names::kLatestQueue, true);
    offerServices();
    statuses_.add("maps", [this](Status* status) { compose(report_, status); });
    timer_ = service_node_.createWallTimer(ros::WallDuration(parameters.publish_period),
                                           &MappingNode::onTimer, this);
  }

  void run() {
    ros::AsyncSpinner services(kServiceThreads, &service_queue_);
    services.start();
    ros::spin();
  }

 private:
  using Octomap = octomap_msgs::GetOctomap;
  using MakeOctomap = octomap_msgs::Octomap (*)(const VoxelGrid&, const std_msgs::Header&);

  ros::NodeHandle makeServiceNode() {
    ros::NodeHandle node;
    node.setCallbackQueue(&service_queue_);
    return node;
  }

  void offerServices() {
    servers_ = {
        service_node_.advertiseService(names::kResetMaps, &MappingNode::onReset, this),
        offerReset(names::kWorldMap, MapSide::kWorld),
        offerReset(names::kObjectMap, MapSide::kObject),
        service_node_.advertiseService(names::kInsertPrior, &MappingNode::onInsertPrior, this),
        service_node_.advertiseService(names::kSaveMaps, &MappingNode::onSave, this),
        service_node_.advertiseService(names::kSaveBelief, &MappingNode::onSaveBelief, this),
        service_node_.advertiseService(names::kLoadBelief, &MappingNode::onLoadBelief, this),
        offerOctomap(names::kWorldMap, names::kOctomapFull, &fullOctomap),
        offerOctomap(names::kWorldMap, names::kOctomapBinary, &binaryOctomap),
        offerOctomap(names::kObjectMap, names::kOctomapFull, &fullOctomap),
        offerOctomap(names::kObjectMap, names::kOctomapBinary, &binaryOctomap),
    };
  }

  ros::ServiceServer offerOctomap(const std::string& space, const std::string& name,
                                  MakeOctomap make) {
    const bool of_world = space == names::kWorldMap;
    const boost::function<bool(Octomap::Request&, Octomap::Response&)> reply =
        [this, of_world, make](Octomap::Request& /*request*/, Octomap::Response& response) {
          keeper_->access([&](const MapState& state) {
            const VoxelGrid& grid = of_world ? state.maps->world() : state.maps->object();
            response.map = make(grid, (of_world ? world_ : object_).headerAt(timeOf(state.stamp)));
          });
          return true;
        };
    return service_node_.advertiseService(space + "/" + name, reply);
  }

  void onContact(const smore_msgs::ContactObservation& message) {
    const Result<ContactObservation> observation = fromMessage(message);
    if (!observation) {
      if (warning_.isDue()) ROS_ERROR_STREAM("observation left out: " << observation.reason());
      return;
    }
    if (message.header.frame_id != parameters_.frames.object ||
        message.world_frame != parameters_.frames.world) {
      if (warning_.isDue())
        ROS_ERROR_STREAM("observation left out: it is given in the frames '"
                         << message.world_frame << "' and '" << message.header.frame_id
                         << "'; give the listener and the mapping the same frames");
      return;
    }
    const std::string beside = space_.whyBeside(observation->T_world_object);
    if (!beside.empty() && beside_warning_.isDue())
      ROS_WARN_STREAM("observations are left out: the object is " << beside);
    keeper_->push(*observation);
  }

  bool onReset(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response) {
    keeper_->reset();
    response.success = true;
    response.message = "all observations are forgotten";
    return true;
  }

  ros::ServiceServer offerReset(const std::string& space, MapSide side) {
    using Trigger = std_srvs::Trigger;
    const boost::function<bool(Trigger::Request&, Trigger::Response&)> reply =
        [this, space, side](Trigger::Request& /*request*/, Trigger::Response& response) {
          response.success = tell(&response.message, [&] { return forget(space, side); });
          return true;
        };
    return service_node_.advertiseService(space + "/" + names::kResetMaps, reply);
  }

  std::string forget(const std::string& map, MapSide side) {
    if (source_.method != MethodKind::kSmore) {
      throw InputError("the method " + methodName(source_.method) +
                       " cannot keep one map without the other; reset both, or use smore");
    }
    keeper_->reset(side);
    return "the " + map + " map is forgotten; what was sure in the other one is known beforehand";
  }

  bool onInsertPrior(smore_msgs::InsertPrior::Request& request,
                     smore_msgs::InsertPrior::Response& response) {
    response.success = tell(&response.message, [&] {
      const PriorRequest told =
          readRequest(request, parameters_.frames, [this](const auto& target, const auto& cloud) {
            return cloud_frames_.poseIn(target, cloud);
          });
      const Prior prior = makePrior(source_.task, told.side, told.source);
      keeper_->know(told.side, prior);
      return "known of the " + request.map + " now: " + std::to_string(prior.known.size()) +
             " voxels of " + (request.file.empty() ? "the cloud" : request.file);
    });
    return true;
  }

  bool onSave(smore_msgs::SaveMaps::Request& request, smore_msgs::SaveMaps::Response& response) {
    response.success = tell(&response.message, [&] {
      saveMaps(*keeper_, request.directory);
      return "wrote world.ot and object.ot into " + request.directory;
    });
    return true;
  }

  bool onSaveBelief(smore_msgs::SaveBelief::Request& request,
                    smore_msgs::SaveBelief::Response& response) {
    response.success = tell(&response.message, [&] {
      return "wrote " + files_.save(*keeper_, request.file, request.overwrite);
    });
    return true;
  }

  bool onLoadBelief(smore_msgs::LoadBelief::Request& request,
                    smore_msgs::LoadBelief::Response& response) {
    response.success =
        tell(&response.message, [&] { return files_.load(request.file, keeper_.get()); });
    return true;
  }

  /// Whether `act` succeeds; what it says, or the reason why not.
  static bool tell(std::string* message, const std::function<std::string()>& act) {
    try {
      *message = act();
      return true;
    } catch (const std::runtime_error& error) {
      *message = error.what();
      return false;
    }
  }

  void onTimer(const ros::WallTimerEvent& /*event*/) {
    tellProblems();
    for (MapPublisher* map : {&world_, &object_}) map->showFrom(display_.minProbability());
    std::optional<smore_msgs::EvidenceSource> source;
    std::optional<VoxelGrid> world, object;
    std::shared_ptr<const Worlds> worlds;
    std::vector<LineOfAction> lines;
    std::uint64_t revision = 0, epoch = 0;
    ros::Time stamp;
    keeper_->access([&](const MapState& state) {
      revision = revisionOf(state);
      stamp = timeOf(state.stamp);
      lines = state.lines;
      epoch = state.log.epoch();
      report_.observations = state.log.size();
      if (std::exchange(epoch_told_, epoch) != epoch) source = sourceMessage(source_, state);
      if (world_.isDue(revision)) world = state.maps->world();
      if (object_.isDue(revision)) object = state.maps->object();
      if (belief_.isDue(revision)) worlds = worldsOf(*state.maps);
    });
    if (world) world_.publish(*world, revision, stamp);
    if (object) object_.publish(*object, revision, stamp);
    if (source) source_told_.publish(*source);
    if (worlds) belief_.publish(*worlds, revision);
    belief_.publish(lines, epoch, display_.lineHalfLength());
    report_.lines = lines.size();
    report_.revision = revision;
    publishStatus();
  }

  void tellProblems() {
    const KeeperProblems problems = keeper_->takeProblems();
    for (const std::string& problem : {problems.left_out, problems.journal_end}) {
      if (!problem.empty()) ROS_ERROR_STREAM(problem);
    }
    note(problems, &report_);
  }

  void publishStatus() {
    note(keeper_->arrivals(), &report_);
    report_.shown_from = display_.minProbability();
    report_.world_voxels = world_.voxels();
    report_.object_voxels = object_.voxels();
    statuses_.publishIfDue();
  }

  MappingParameters parameters_;
  EvidenceSource source_;
  MotionSpace space_;
  BeliefFiles files_;
  CloudFrames cloud_frames_;
  std::unique_ptr<MapKeeper> keeper_;  ///< before anything is offered of what it knows
  ros::CallbackQueue service_queue_;
  ros::NodeHandle node_;
  ros::NodeHandle service_node_;
  DisplaySettings display_;
  BeliefDisplay belief_;
  MapPublisher world_, object_;
  ros::Publisher source_told_;
  std::uint64_t epoch_told_ = 0;
  ros::Subscriber contact_;
  std::vector<ros::ServiceServer> servers_;
  TwinMapsService twin_maps_{parameters_.frames, keeper_.get()};
  ros::WallTimer timer_;
  MappingReport report_;
  StatusPublisher statuses_;
  Throttle beside_warning_{kWarningPeriod};
  Throttle warning_{kWarningPeriod};
};

void runMapping() {
  ParameterReader reader(privateParameters(), ros::this_node::getName());
  const MappingParameters parameters = readMappingParameters(&reader);
  const std::optional<Scenario> scenario = readScenarioParameter(&reader);
  requireScenario(&reader);
  reader.finish();
  MappingNode(parameters, sourceOf(parameters, *scenario)).run();
}

}  // namespace
}  // namespace smore

int main(int argc, char** argv) { return smore::runNode(argc, argv, "mapping", smore::runMapping); }
