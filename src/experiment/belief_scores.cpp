// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/belief_scores.h"

#include <algorithm>
#include <numeric>
#include <random>

#include "smore/common/result.h"
#include "smore/experiment/contact_place.h"
#include "smore/experiment/first_touch.h"
#include "smore/experiment/scored_belief.h"
#include "smore/planning/risk_calibration.h"

namespace smore {
namespace {

bool cameToAnEnd(const RecordedMotion& motion) {
  return motion.path.size() >= 2 &&
         (motion.end == MotionEnd::kReached || motion.end == MotionEnd::kContact);
}

// So many of the motions, evenly spaced, the last one among them.
std::vector<const RecordedMotion*> chosenMotions(const Evidence& evidence, int most) {
  std::vector<const RecordedMotion*> ended;
  for (const RecordedMotion& motion : evidence.motions) {
    if (cameToAnEnd(motion)) ended.push_back(&motion);
  }
  const auto count = std::min(ended.size(), static_cast<std::size_t>(most));
  std::vector<const RecordedMotion*> chosen;
  for (std::size_t i = 1; i <= count; ++i) chosen.push_back(ended[i * ended.size() / count - 1]);
  return chosen;
}

// The last motion of a retrieval that reached the goal; touches for the maps' sake state no risk.
const RecordedMotion* wayOut(const Evidence& evidence) {
  if (!evidence.outcome || !evidence.outcome->success) return nullptr;
  const auto way = std::find_if(
      evidence.motions.rbegin(), evidence.motions.rend(), [](const RecordedMotion& motion) {
        return motion.risk && cameToAnEnd(motion) && motion.end == MotionEnd::kReached;
      });
  return way == evidence.motions.rend() ? nullptr : &*way;
}

class TrialReplay {
 public:
  TrialReplay(const Evidence& evidence, const TrialTruth& truth, const ScoreEffort& effort)
      : evidence_(evidence),
        truth_(truth),
        effort_(effort),
        task_(evidence.source.task),
        speed_{task_.linear_speed, task_.angular_speed},
        motions_(chosenMotions(evidence, effort.most_motions)),
        way_out_(wayOut(evidence)),
        belief_(makeBelief()),
        calibration_(task_.motion) {}

  TrialScores run() {
    scores_.scene = task_.name;
    scores_.motion = task_.motion;
    scores_.worlds = belief_.worldCount();
    scores_.scatter.resize(effort_.moments);
    for (std::size_t i = 0; i < motions_.size(); ++i) {
      observeUntil(motions_[i]->observations_before);
      askBefore(*motions_[i]);
      scatterBefore(i);
    }
    observeUntil(evidence_.observations.size());
    scores_.places_after = logPlaces();
    scores_.contacts_of_many_places = static_cast<int>(
        std::count(places_.begin(), places_.end(), std::optional<Vec3>(std::nullopt)));
    scores_.object_voxels = voxelForecasts(belief_.object(), truth_.object);
    scores_.world_voxels = voxelForecasts(belief_.world(), truth_.environment);
    shuffle();
    return std::move(scores_);
  }

 private:
  ScoredBelief makeBelief() const {
    const EvidenceSource& source = evidence_.source;
    return {task_, source.parameters, source.seed, source.priors};
  }

  void observeUntil(std::size_t end) {
    for (; observed_ < end; ++observed_) {
      const ContactObservation& observation = evidence_.observations[observed_];
      belief_.observe(observation);
      if (!observation.line) continue;
      contacts_.push_back(&observation);
      places_.push_back(truePlace(observation, truth_));
    }
  }

  void askBefore(const RecordedMotion& motion) {
    const bool touched = motion.end == MotionEnd::kContact;
    const double planned = belief_.riskOf(motion.path);
    scores_.risks.push_back({calibration_.corrected(planned), touched});
    calibration_.learn(planned, touched);
    const std::vector<Path> legs = legsOf(motion.path, speed_);
    if (!legs.empty()) {
      std::optional<int> leg;
      if (touched) leg = legAt(legs, motion.T_world_end, speed_);
      scores_.touches.push_back({logFirstTouch(belief_.survival(legs), leg), leg});
    }
    const std::vector<double> places = logPlaces();
    if (!places.empty()) {
      scores_.places_before.push_back(std::accumulate(places.begin(), places.end(), 0.0) /
                                      static_cast<double>(places.size()));
    }
    // Once it has been travelled it is known to be free.
    const bool is_sought = way_out_ != nullptr && &motion <= way_out_;
    if (is_sought && belief_.contactCount() > 0) {
      scores_.way_out.push_back(belief_.touchingShare(way_out_->path));
    }
  }

  // Of each contact so far that had one place.
  std::vector<double> logPlaces() const {
    const double range = (task_.workspace.max - task_.workspace.min).norm();
    std::vector<double> logs;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      if (!places_[i]) continue;
      logs.push_back(logPlaceDensity(belief_.placesOf(*contacts_[i]), *contacts_[i]->line,
                                     *places_[i], 0.5 * task_.voxel_size, range,
                                     task_.motion == Motion::kPlanar));
    }
    return logs;
  }

  // At evenly spaced motions, the last one among them.
  void scatterBefore(std::size_t motion) {
    for (int moment = 0; moment < effort_.moments; ++moment) {
      if (motion + 1 !=
          std::max<std::size_t>(1, (moment + 1) * motions_.size() / effort_.moments)) {
        continue;
      }
      scores_.scatter[moment] += drawnWithOtherSeeds(motion);
    }
  }

  // Of the motions from `first` on: what an earlier one met is known.
  SeedScatter drawnWithOtherSeeds(std::size_t first) {
    std::vector<std::vector<double>> shares(motions_.size() - first);
    for (int seed = 1; seed <= effort_.seeds; ++seed) {
      belief_.drawAnew(evidence_.source.seed + seed);
      for (std::size_t i = first; i < motions_.size(); ++i) {
        shares[i - first].push_back(belief_.touchingShare(motions_[i]->path));
      }
    }
    belief_.drawAnew(evidence_.source.seed);
    SeedScatter scatter;
    for (const std::vector<double>& of_motion : shares) scatter += scatterOf(of_motion);
    return scatter;
  }

  void shuffle() {
    std::mt19937_64 random(evidence_.source.seed);
    std::vector<ContactObservation> observations = evidence_.observations;
    for (int i = 0; i < effort_.shuffles; ++i) {
      std::shuffle(observations.begin(), observations.end(), random);
      ScoredBelief other = makeBelief();
      for (const ContactObservation& observation : observations) other.observe(observation);
      for (const MapDifference& difference : {differenceOf(belief_.world(), other.world()),
                                              differenceOf(belief_.object(), other.object())}) {
        scores_.order.largest = std::max(scores_.order.largest, difference.largest);
        scores_.order.sum += difference.sum;
        scores_.order.voxels += difference.voxels;
      }
    }
  }

  const Evidence& evidence_;
  const TrialTruth& truth_;
  ScoreEffort effort_;
  const Scenario& task_;
  MotionSpeed speed_;
  std::vector<const RecordedMotion*> motions_;
  const RecordedMotion* way_out_;
  ScoredBelief belief_;
  RiskCalibration calibration_;  ///< by the motions that are asked about
  std::size_t observed_ = 0;
  std::vector<const ContactObservation*> contacts_;  ///< those with a line
  std::vector<std::optional<Vec3>> places_;          ///< the true ones, in the object frame
  TrialScores scores_;
};

}  // namespace

TrialScores scoreTrial(const Evidence& evidence, const TrialTruth& truth,
                       const ScoreEffort& effort) {
  try {
    return TrialReplay(evidence, truth, effort).run();
  } catch (const std::out_of_range& error) {
    throw InputError(evidence.file + ": an observation lies outside of the maps (" + error.what() +
                     ")");
  }
}

}  // namespace smore
