// SPDX-License-Identifier: BSD-3-Clause
#include "smore/ros/evidence_messages.h"

#include "smore/mapping/voxel_runs.h"
#include "smore/ros/names.h"

namespace smore {
namespace {

smore_msgs::Prior toMessage(const Prior& prior, const char* map) {
  smore_msgs::Prior message;
  message.map = map;
  message.confidence = prior.confidence;
  message.voxel_size = prior.known.voxelSize();
  message.matter = runsOf(prior.known, true);
  message.free = runsOf(prior.known, false);
  return message;
}

Result<Prior> fromMessage(const smore_msgs::Prior& message) {
  const bool is_size = message.voxel_size > 0.0 && std::isfinite(message.voxel_size);
  const bool is_probability = message.confidence > 0.0 && message.confidence < 1.0;
  if (!is_size || !is_probability) return Failure{"a piece of knowledge with impossible values"};
  Prior prior{VoxelGrid(message.voxel_size), message.confidence};
  if (!setRuns(message.matter, 1.0F, &prior.known) || !setRuns(message.free, 0.0F, &prior.known)) {
    return Failure{"a piece of knowledge whose voxels are no runs"};
  }
  return prior;
}

}  // namespace

smore_msgs::Evidence evidenceSince(const MapState& state, std::uint64_t epoch, std::uint64_t from,
                                   const FrameNames& frames) {
  const bool same_epoch = epoch == state.log.epoch();
  smore_msgs::Evidence message;
  message.epoch = state.log.epoch();
  message.changes = changesOf(state);
  message.first = same_epoch ? from : 0;
  for (const ContactObservation& entry : state.log.from(message.first)) {
    message.observations.push_back(toMessage(entry, frames));
  }
  if (same_epoch) return message;
  for (const Prior& prior : state.priors.object) {
    message.priors.push_back(toMessage(prior, names::kObjectMap));
  }
  for (const Prior& prior : state.priors.world) {
    message.priors.push_back(toMessage(prior, names::kWorldMap));
  }
  return message;
}

smore_msgs::EvidenceSource sourceMessage(EvidenceSource source, const MapState& state) {
  source.priors = state.priors;
  smore_msgs::EvidenceSource message;
  message.since.fromSec(state.since);
  message.whole = static_cast<unsigned char>(state.whole);
  message.records = toRecords(source);
  return message;
}

Result<EvidencePart> fromMessage(const smore_msgs::Evidence& message) {
  EvidencePart part;
  part.epoch = message.epoch;
  part.first = message.first;
  part.changes = message.changes;
  for (const smore_msgs::Prior& piece : message.priors) {
    const Result<Prior> prior = fromMessage(piece);
    if (!prior) return Failure{prior.reason()};
    const bool of_object = piece.map == names::kObjectMap;
    part.priors.of(of_object ? MapSide::kObject : MapSide::kWorld).push_back(*prior);
  }
  for (const auto& entry : message.observations) {
    const Result<ContactObservation> observation = fromMessage(entry);
    if (!observation) return Failure{observation.reason()};
    part.observations.push_back(*observation);
  }
  return part;
}

}  // namespace smore
