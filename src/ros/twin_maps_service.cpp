// SPDX-License-Identifier: BSD-3-Clause
#include "twin_maps_service.h"

#include <algorithm>

#include "smore/ros/evidence_messages.h"
#include "smore/ros/map_conversions.h"
#include "smore/ros/names.h"

namespace smore {
namespace {

constexpr double kMostWait = 60.0;  // [s] of a caller: threads are few, and end with the node

}  // namespace

TwinMapsService::TwinMapsService(const FrameNames& frames, const MapKeeper* keeper)
    : frames_(frames), keeper_(keeper) {
  node_.setCallbackQueue(&queue_);
  server_ = node_.advertiseService(names::kTwinMaps, &TwinMapsService::onCall, this);
  threads_.start();
}

bool TwinMapsService::onCall(smore_msgs::TwinMaps::Request& request,
                             smore_msgs::TwinMaps::Response& response) {
  const bool may_wait = callers_++ < kMostWaiting;
  const double timeout = may_wait ? std::min(request.timeout.toSec(), kMostWait) : 0.0;
  const bool is_there = keeper_->waitFor(request.not_before.toSec(), timeout);
  --callers_;
  if (!is_there) {
    response.message = "the maps do not hold the observations up to the time asked for; ";
    response.message += may_wait ? "check that contact observations arrive"
                                 : std::to_string(kMostWaiting) +
                                       " callers wait already, and no more may: call again";
    return true;
  }
  keeper_->access([&](const MapState& state) { fill(request, state, &response); });
  response.success = true;
  return true;
}

void TwinMapsService::fill(const smore_msgs::TwinMaps::Request& request, const MapState& state,
                           smore_msgs::TwinMaps::Response* response) const {
  response->revision = revisionOf(state);
  response->stamp.fromSec(state.stamp);
  if (request.with_octrees) {
    response->world = fullOctomap(state.maps->world(), headerOf(frames_.world, response->stamp));
    response->object = fullOctomap(state.maps->object(), headerOf(frames_.object, response->stamp));
  }
  if (!request.with_evidence) return;
  response->evidence = evidenceSince(state, request.epoch, request.evidence_from, frames_);
}

}  // namespace smore
