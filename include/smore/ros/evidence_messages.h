// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smore/ros/conversions.h"
#include "smore/ros/map_keeper.h"
#include "smore/ros/method_replica.h"

namespace smore {

/// What somebody lacks of the evidence who has that of `epoch` up to position `from`: all of it
/// where the log has another epoch.
smore_msgs::Evidence evidenceSince(const MapState& state, std::uint64_t epoch, std::uint64_t from,
                                   const FrameNames& frames);

/// What the maps follow from; `source` but for what is known beforehand, which the state says.
smore_msgs::EvidenceSource sourceMessage(EvidenceSource source, const MapState& state);

/// A failure for observations or pieces of knowledge that are none.
Result<EvidencePart> fromMessage(const smore_msgs::Evidence& message);

}  // namespace smore
