// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/contact_risk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "smore/planning/fresh_cells.h"
#include "smore/planning/risk_motion.h"

namespace smore {
namespace {

// Probability that one more world would touch: with Jeffreys' prior for a share, none in a number
// of independent worlds is not yet never.
double predictedShare(double share) { return (kHypotheses * share + 0.5) / (kHypotheses + 1.0); }

// Poses whose mean stands for all that were free.
constexpr std::size_t kMostSamples = 64;

// Cells that were free, each as far as something unknown might have touched there; one at least.
double knownCells(const Worlds& worlds) {
  std::size_t poses = 0;
  for (const Path& track : worlds.tracks) poses += track.size();
  const std::size_t step = 1 + poses / kMostSamples;
  double sum = 0.0;
  int count = 0;
  std::size_t next = 0;
  for (const Path& track : worlds.tracks) {
    for (const Pose& pose : track) {
      if (next++ % step != 0) continue;
      sum += worlds.sampled.unknownShareAt(worlds.frame.toMap(pose).cast<float>());
      ++count;
    }
  }
  const double share = count > 0 ? sum / count : 1.0;
  return std::max(1.0, share * static_cast<double>(worlds.free.count()));
}

double entropyTerm(double probability) {
  return probability > 0.0 ? -probability * std::log(probability) : 0.0;
}

}  // namespace

ContactRisk::ContactRisk(std::shared_ptr<const Worlds> worlds)
    : worlds_(std::move(worlds)),
      check_distance_(checkDistance(worlds_->sampled)),
      check_angle_(check_distance_ /
                   std::max(worlds_->feature.reach, worlds_->sampled.knownReach())),
      known_cells_(knownCells(*worlds_)) {}

HypothesisMask ContactRisk::touching(const Pose& T_world_object) const {
  return worlds_->sampled.touching(worlds_->frame.toMap(T_world_object).cast<float>());
}

HypothesisMask ContactRisk::touchingAlong(const Path& path) const {
  HypothesisMask mask = 0;
  for (const Pose& pose : densify(path, check_distance_, check_angle_)) mask |= touching(pose);
  return mask;
}

double ContactRisk::noSurpriseIn(double fresh) const {
  return known_cells_ / (known_cells_ + fresh);
}

double ContactRisk::ofMotion(const Path& path) const {
  const FreeSpaceParameters& cell = worlds_->free.parameters();
  FreshCells fresh(*worlds_);
  for (const Pose& pose : densify(path, cell.position_cell, cell.angle_cell)) fresh.enter(pose);
  const double touched = predictedShare(along(path));
  return 1.0 - (1.0 - touched) * noSurpriseIn(fresh.count());
}

double ContactRisk::informationOf(const Path& path) const {
  const FreeSpaceParameters& cell = worlds_->free.parameters();
  HypothesisMask touched = 0;
  FreshCells fresh(*worlds_);
  double no_surprise = 1.0;
  double surprise = 0.0;
  double entropy = 0.0;
  for (const Pose& pose : densify(path, cell.position_cell, cell.angle_cell)) {
    const HypothesisMask first = touching(pose) & ~touched;
    touched |= first;
    entropy += entropyTerm(no_surprise * SampledWorlds::shareOf(first));
    const double before = no_surprise;
    fresh.enter(pose);
    no_surprise = noSurpriseIn(fresh.count());
    surprise += SampledWorlds::shareOf(~touched) * (before - no_surprise);
  }
  entropy += entropyTerm(surprise) + surprise * std::log(std::max(1.0, patchesOfObject()));
  return entropy + entropyTerm(no_surprise * SampledWorlds::shareOf(~touched));
}

double ContactRisk::patchesOfObject() const {
  const double size = worlds_->feature.reach / worlds_->feature.conflictDistance();
  return worlds_->frame.planar() ? 2.0 * M_PI * size : 4.0 * M_PI * size * size;
}

}  // namespace smore
