// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/joint_belief.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "smore/common/elapsed_time.h"
#include "smore/common/result.h"
#include "smore/mapping/contact_merging.h"
#include "smore/mapping/free_tracks.h"
#include "smore/mapping/repeated_touches.h"

namespace smore {
namespace {

// Parts of equal probability into which the unit of length falls: each costs an inference.
constexpr int kStrata = 3;

// Share of the contacts that is merged when there are too many: not each new one costs a merge.
constexpr int kMergedShare = 10;  // one in so many

// By time, and by their numbers where they were made at one time.
bool isBefore(const StampedPose& a, const StampedPose& b) {
  if (a.time != b.time) return a.time < b.time;
  const double *of_a = a.T_map_object.data(), *of_b = b.T_map_object.data();
  return std::lexicographical_compare(of_a, of_a + 16, of_b, of_b + 16);
}

int likeliestOf(const std::array<int, kUnits>& counts) {
  return static_cast<int>(std::max_element(counts.begin(), counts.end()) - counts.begin());
}

FeatureParameters featureAt(const JointBeliefParameters& parameters, int index) {
  return inMetres(parameters, unitOfLength(index), unitOfLength(index)).feature;
}

// Hypotheses in an order in which those of any part of it have surfaces of all sizes.
int scattered(int place) { return (27 * place + 5) % kHypotheses; }

}  // namespace

JointBelief::JointBelief(const JointBeliefParameters& parameters)
    : parameters_(parameters), frame_(parameters.T_world_plane), free_(kPoseAccuracy) {}

void JointBelief::observe(const ContactObservation& observation) {
  if (!isFinite(observation.T_world_object)) return;
  (void)voxelAt(observation.T_world_object.translation(), parameters_.voxel_size);  // in range
  const bool free = observation.state == ContactState::kFree;
  if (!free || observation.line) noteContact(observation);  // the line of a contact that was short
  if (free) addFree(observation.T_world_object);
}

void JointBelief::change() {
  ++revision_;
  worlds_ = nullptr;
}

void JointBelief::noteContact(const ContactObservation& observation) {
  if (observation.line && addContact(observation.T_world_object, *observation.line)) {
    std::optional<StampedPose>& without_line = poses_without_line_[observation.contact_id];
    if (without_line) change();
    without_line = std::nullopt;
    return;
  }
  if (observation.state != ContactState::kContact) return;  // unsure: with the line of a short one
  const StampedPose touched{observation.time, toMap(observation.T_world_object)};
  const auto [known, is_new] = poses_without_line_.emplace(observation.contact_id, touched);
  if (!is_new && (!known->second || !isBefore(touched, *known->second))) return;
  known->second = touched;
  change();
}

// All that is inferred is inferred from the centres of cells, whichever pose entered one first.
void JointBelief::addFree(const Pose& T_world_object) {
  if (!free_.add(T_world_object)) return;
  trail_.push_back(free_.centerOf(T_world_object));
  // Without contacts and prior knowledge the maps stay empty.
  if (!contacts_.empty() || !known_.empty()) ++revision_;
  bool news = at_unit_.empty();
  for (auto& [units, evidence] : at_unit_) news = evidence.addFree(toMap(trail_.back())) || news;
  if (news) worlds_ = nullptr;
}

bool JointBelief::addContact(const Pose& T_world_object, const LineOfAction& line) {
  const auto places = widestPlacesOf(T_world_object, line);
  if (!places) return false;
  if (!levers_.emplace(places->id, places->lever).second) return true;
  const ObservedContact contact{places->id, T_world_object, line};
  contacts_.emplace(contact.id, contact);
  for (auto& [units, evidence] : at_unit_) evidence.addContact(contact);
  change();
  if (static_cast<int>(contacts_.size()) > parameters_.most_contacts) mergeContacts();
  return true;
}

// At the unit at which a line may pass farthest from the hand.
std::optional<ContactHypotheses> JointBelief::widestPlacesOf(const Pose& T_world_object,
                                                             const LineOfAction& line) const {
  const FeatureParameters widest = featureAt(parameters_, kUnits - 1);
  return contactHypotheses(frame_.T_map_world() * T_world_object, line, widest, frame_.planar());
}

// Those that are out of reach at the likeliest unit say nothing there; then those that are covered.
void JointBelief::mergeContacts() {
  DrawnByUnit drawn;
  const int likeliest = likeliestOf(worldsByUnit(&drawn));
  const EvidenceAtUnit& evidence = atUnit(likeliest, drawn);
  std::vector<int> members(kHypotheses);
  std::iota(members.begin(), members.end(), 0);
  const int surplus = parameters_.most_contacts / kMergedShare;
  std::vector<std::uint64_t> merged;
  for (const auto& [id, contact] : contacts_) {
    if (!evidence.knows(id) && static_cast<int>(merged.size()) < surplus) merged.push_back(id);
  }
  for (const int contact : coveredContacts(
           evidence.contacts(), evidence.explain(drawnAt(likeliest, &drawn), members).explanations,
           evidence.parameters().distribution, surplus - static_cast<int>(merged.size()))) {
    merged.push_back(evidence.contacts()[contact].id);
  }
  for (const std::uint64_t id : merged) {
    contacts_.erase(id);
    for (auto& entry : at_unit_) entry.second.removeContact(id);
  }
  worlds_ = nullptr;
}

std::vector<std::optional<Vec3>> JointBelief::placesOf(const Pose& T_world_object,
                                                       const LineOfAction& line) const {
  const auto observed = widestPlacesOf(T_world_object, line);
  if (!observed) return {};
  const TouchedPlaces& touched = worlds()->touched;
  const auto known = touched.find(observed->id);
  return known == touched.end() ? std::vector<std::optional<Vec3>>() : known->second;
}

void JointBelief::drawAnew(std::uint64_t seed) {
  parameters_.seed = seed;
  change();
}

void JointBelief::know(MapSide side, const Prior& prior) {
  const Pose T_frame_grid = side == MapSide::kWorld ? frame_.T_map_world() : Pose::Identity();
  auto known = std::make_shared<const KnownMatter>(side, prior, T_frame_grid, frame_.planar());
  // By their ids: the order in which they are told leaves no trace.
  const auto place =
      std::lower_bound(known_.begin(), known_.end(), known->id(),
                       [](const auto& piece, std::uint64_t id) { return piece->id() < id; });
  if (place != known_.end() && (*place)->id() == known->id()) return;
  if (known_.size() == kMostPriors) {
    throw InputError("more than " + std::to_string(kMostPriors) +
                     " pieces of prior knowledge; put some of them together");
  }
  known_.insert(place, std::move(known));
  change();
}

std::shared_ptr<const Worlds> JointBelief::worlds() const {
  const std::lock_guard<std::mutex> lock(*inferring_);
  if (!worlds_) worlds_ = std::make_shared<const Worlds>(infer());
  return worlds_;
}

const DrawnEvidence& JointBelief::drawnAt(int index, DrawnByUnit* drawn) const {
  const auto known = drawn->at.find(index);
  if (known != drawn->at.end()) return known->second;
  const EvidenceAtUnit& evidence = atUnit(index, *drawn);
  return drawn->at.emplace(index, evidence.draw(known_, parameters_.seed)).first->second;
}

std::array<int, kUnits> JointBelief::worldsByUnit(DrawnByUnit* drawn) const {
  std::array<int, kUnits> all_alike{};
  all_alike[parameters_.unit > 0.0 ? 0 : kUnits / 2] = kHypotheses;
  const std::vector<LeverOfContact> known = leversOfObject(known_);
  if (parameters_.unit > 0.0 || (levers_.empty() && known.empty())) return all_alike;
  std::vector<LeverOfContact> levers;
  levers.reserve(levers_.size());
  for (const auto& entry : levers_) levers.push_back(entry.second);
  const std::array<double, kUnits> by_levers = unitProbabilities(levers, frame_.planar(), known);
  const std::array<int, kUnits> likely = worldsOfUnits(by_levers, kStrata, kStrata);
  while (likely[drawn->held] == 0) ++drawn->held;
  int largest = kUnits - 1;
  while (likely[largest] == 0) --largest;
  const double widest = featureAt(parameters_, largest).reach;
  const auto evidence = [&](int index) {
    const std::vector<JointSample>& samples = drawnAt(index, drawn).samples;
    return atUnit(index, *drawn).evidenceOf(samples, contacts_.size(), widest);
  };
  return worldsOfUnits(probabilitiesByEvidence(by_levers, kStrata, evidence), kHypotheses, kStrata);
}

// Made anew from all observations where the unit has become likely.
EvidenceAtUnit& JointBelief::atUnit(int index, const DrawnByUnit& drawn) const {
  const std::pair<int, int> units{index, std::max(index, drawn.held)};
  const auto known = at_unit_.find(units);
  if (known != at_unit_.end()) return known->second;
  const double told = parameters_.unit;
  const auto metres = [told](int unit) { return told > 0.0 ? told : unitOfLength(unit); };
  EvidenceAtUnit made(parameters_, frame_, metres(units.first), metres(units.second));
  EvidenceAtUnit& evidence = at_unit_.emplace(units, std::move(made)).first->second;
  for (const auto& entry : contacts_) evidence.addContact(entry.second);
  std::vector<Pose> free(trail_.size());
  std::transform(trail_.begin(), trail_.end(), free.begin(), [this](auto& T) { return toMap(T); });
  evidence.addFree(free);
  return evidence;
}

Worlds JointBelief::infer() const {
  const auto begin = SteadyClock::now();
  DrawnByUnit drawn;
  const std::array<int, kUnits> counts = worldsByUnit(&drawn);
  TouchedPlaces touched;
  SampledWorlds sampled = sampledWorlds(counts, &drawn, &touched);
  forgetOtherUnits(drawn);
  const EvidenceAtUnit& main = atUnit(likeliestOf(counts), drawn);
  const double unit = meanUnit(&EvidenceAtUnit::unit, counts, drawn);
  return {frame_,
          unit,
          meanUnit(&EvidenceAtUnit::held, counts, drawn),
          main.parameters().feature,
          main.free().cells(),
          freeTracks(trail_, unit),
          levers_.size(),
          std::move(sampled),
          std::move(touched),
          secondsSince(begin)};
}

void JointBelief::forgetOtherUnits(const DrawnByUnit& drawn) const {
  for (auto known = at_unit_.begin(); known != at_unit_.end();) {
    const auto [index, held] = known->first;
    const bool asked = drawn.at.count(index) > 0 && held == std::max(index, drawn.held);
    known = asked ? std::next(known) : at_unit_.erase(known);
  }
}

// Geometric.
double JointBelief::meanUnit(UnitOf unit, const std::array<int, kUnits>& counts,
                             const DrawnByUnit& drawn) const {
  double log_unit = 0.0;
  for (int i = 0; i < kUnits; ++i) {
    if (counts[i] > 0) log_unit += counts[i] * std::log((atUnit(i, drawn).*unit)());
  }
  return std::exp(log_unit / kHypotheses);
}

SampledWorlds JointBelief::sampledWorlds(const std::array<int, kUnits>& counts, DrawnByUnit* drawn,
                                         TouchedPlaces* touched) const {
  std::vector<WorldsAtUnit> parts;
  int place = 0;
  for (int i = 0; i < kUnits; ++i) {
    if (counts[i] == 0) continue;
    std::vector<int> members;
    for (const int end = place + counts[i]; place < end; ++place) {
      members.push_back(scattered(place));
    }
    const EvidenceAtUnit& evidence = atUnit(i, *drawn);
    const ExplainedEvidence explained = evidence.explain(drawnAt(i, drawn), members);
    for (const int m : members) {
      evidence.tellPlaces(explained.explanations[m], m, touched);
    }
    parts.push_back(worldsAt(evidence, explained, members));
  }
  return SampledWorlds(std::move(parts));
}

// Of the contacts that take part.
std::vector<Pose> JointBelief::touchedPoses() const {
  std::vector<Pose> poses;
  for (const auto& [id, contact] : contacts_) poses.push_back(toMap(contact.T_world_object));
  return poses;
}

WorldsAtUnit JointBelief::worldsAt(const EvidenceAtUnit& evidence,
                                   const ExplainedEvidence& explained,
                                   const std::vector<int>& members) const {
  const JointBeliefParameters& lengths = evidence.parameters();
  HypothesisMask mask = 0;
  for (const int m : members) mask |= HypothesisMask{1} << m;
  WorldsAtUnit worlds(
      {evidence.contacts(), evidence.free(), explained.explanations, mask, explained.prior},
      lengths.feature, lengths.extent, frame_.planar(), parameters_.seed);
  for (const auto& [contact_id, touched] : poses_without_line_) {
    if (!touched) continue;
    worlds.setTouching(touched->T_map_object.cast<float>(), lengths.feature.reach);
  }
  for (const auto& [id, contact] : contacts_) {
    if (evidence.knows(id)) continue;
    worlds.setTouching(toMap(contact.T_world_object).cast<float>(), lengths.feature.reach);
  }
  for (const Pose& T_map_object :
       repeatedTouches(touchedPoses(), lengths.feature.tolerance, lengths.feature.reach)) {
    worlds.setTouching(T_map_object.cast<float>(), lengths.feature.reach);
  }
  return worlds;
}

}  // namespace smore
