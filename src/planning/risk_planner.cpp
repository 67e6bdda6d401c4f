// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/risk_planner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "smore/common/parallel_for.h"
#include "smore/planning/contact_risk.h"
#include "smore/planning/planted_tracks.h"
#include "smore/planning/posture_paths.h"

namespace smore {
namespace {

// Rungs of the ladder: largest share of the worlds that may touch at any one pose.
constexpr std::array<double, 9> kRungs = {0.0, 0.04, 0.1, 0.2, 0.35, 0.5, 0.7, 0.9, 1.0};

// Samples around nodes of the tree, half of them along one axis only: near ones and wider ones.
constexpr double kNearShare = 0.2;
constexpr double kLocalShare = 0.45;
constexpr double kNear = 1.0;             // [units of length]
constexpr double kWide = 3.5;             // [units of length]
constexpr double kRadiansPerUnit = 0.25;  // of local samples: sweeping turns at short distances

// Steps of a chain towards the other tree, at most: what is farther away is left to later samples.
constexpr int kLongestConnection = 60;

// A place nearer than twice this to start or goal cannot be passed beside [units of length].
constexpr double kSmallestBar = 0.01;

constexpr double kMoveDistance = 0.5;  // of inner states of a path [units of length]

// The best paths, which are improved once more.
constexpr std::size_t kFinalists = 3;

void sortByValue(std::vector<RiskPath>* paths) {
  std::stable_sort(paths->begin(), paths->end(), isBetter);
}

double shareWithKnownObject(const SampledWorlds& worlds) {
  HypothesisMask known = 0;
  for (const WorldsAtUnit& part : worlds.parts()) {
    for (const KnownBalls& matter : part.knownObject()) {
      for (const MaskedPoint& ball : matter.balls) known |= ball.mask;
    }
  }
  return SampledWorlds::shareOf(known);
}

}  // namespace

struct RiskPlanner::Search {
  double unit;  ///< of length [m]; all other lengths are in metres
  double step;  ///< longest edge of the trees
  RiskSpace space;
  RiskMotions motions;
  PathValue measure;
  RiskState start;
  RiskState goal;
  std::shared_ptr<const Worlds> worlds;
  std::uint64_t seed;  ///< of this search
  CounterRandom random;
  Deadline deadline;
  std::vector<TreeEdge> edges = {};
};

struct RiskPlanner::Trees {
  RiskTree from_start;
  RiskTree from_goal;
};

RiskPlanner::RiskPlanner(const JointBelief& belief, const MotionSpace& space,
                         const RiskPlannerParameters& parameters, std::uint64_t seed)
    : belief_(&belief), parameters_(parameters), space_(space), seed_(seed) {
  if (space_.motion == Motion::kSpatial) {
    parameters_.improvements = parameters.improvements_in_space;
  }
}

Result<Plan> RiskPlanner::plan(const Pose& start, const Pose& goal) {
  if (!refused_.empty()) {
    Result<Plan> beside = planBeside(refused_, start, goal);
    if (beside) return beside;
  }
  return planBeside({}, start, goal);
}

Result<Plan> RiskPlanner::planBeside(const std::vector<Pose>& refused, const Pose& start,
                                     const Pose& goal) {
  const std::shared_ptr<const Worlds> worlds = belief_->worlds();
  worlds->sampled.prepareTouching();
  const Deadline deadline(parameters_.time_limit);
  const std::uint64_t seed = mixBits(seed_, calls_++);
  const double unit = worlds->unit;
  const RiskObjective& objective = parameters_.objective;
  const RiskSpace space(space_, worlds->frame.T_map_world(), parameters_.lever * worlds->held);
  RiskMotions motions(worlds->sampled, space.lever(), space.fullTurns());
  for (const Pose& T_world_object : refused) {
    const RiskState place = space.toState(T_world_object);
    const double from_ends = std::min(motions.distance(place, space.toState(start)),
                                      motions.distance(place, space.toState(goal)));
    const double radius = std::min(parameters_.step * unit, 0.5 * from_ends);
    if (radius > kSmallestBar * unit) motions.bar({place, radius});
  }
  std::optional<SweptRoom> room;
  const double surprises = surprisesIn(*worlds);
  if (surprises > 0.0) room.emplace(*worlds, space, motions);
  Search search{
      unit,
      parameters_.step * unit,
      space,
      motions,
      {{objective.touch_cost * unit, objective.give * unit}, room ? &*room : nullptr, surprises},
      space.toState(start),
      space.toState(goal),
      worlds,
      seed,
      CounterRandom(seed),
      deadline};
  if (!space.isNearWorkspace(search.start)) return Failure{"the start is outside of the workspace"};
  if (!space.contains(search.goal)) return Failure{"the goal is outside of the workspace"};
  std::vector<RiskPath> paths = climb(&search);
  if (paths.empty()) return Failure{"the planner's iterations were used up at every level of risk"};
  if (!space.planar()) searchFurther(search, &paths);
  sortByValue(&paths);
  if (motions.barsPlaces() && std::isinf(paths.front().value())) {
    return Failure{"each way passes where the robot could not follow"};
  }
  Plan plan;
  for (const RiskState& state : paths.front().states()) plan.path.push_back(space.toPose(state));
  plan.path.front() = start;
  plan.path.back() = goal;
  plan.risk = ContactRisk(worlds).ofMotion(plan.path);
  plan.tree = std::move(search.edges);
  return plan;
}

double RiskPlanner::surprisesIn(const Worlds& worlds) const {
  if (space_.motion == Motion::kPlanar) return 0.0;
  const auto contacts = static_cast<double>(worlds.contacts);
  return std::max(parameters_.surprise_share_in_space * contacts,
                  parameters_.surprises_of_known_object * shareWithKnownObject(worlds.sampled));
}

// In a plane the trees find what there is to find, and more choice only finds more of what the
// worlds have got wrong (docs/planning.md).
void RiskPlanner::searchFurther(const Search& search, std::vector<RiskPath>* paths) {
  const std::size_t improved = paths->size();
  addAlternatives(search, paths);
  addPostures(search, paths);
  improve(search, parameters_.improvements / 2, improved, paths->size(), paths);
  sortByValue(paths);
  improve(search, parameters_.improvements, 0, std::min(kFinalists, paths->size()), paths);
  sortByValue(paths);
  remember(*paths);
}

// What the search found earlier and did not take may be the best by now.
void RiskPlanner::addAlternatives(const Search& search, std::vector<RiskPath>* paths) {
  auto next = alternatives_.begin();
  for (; next != alternatives_.end() && !search.deadline.passed(); ++next) {
    next->front() = search.start;
    next->back() = search.goal;
    paths->emplace_back(search.motions, search.measure, std::move(*next));
  }
  alternatives_.erase(alternatives_.begin(), next);
}

void RiskPlanner::addPostures(const Search& search, std::vector<RiskPath>* paths) const {
  const PosturePaths postures(search.motions, search.space, search.measure);
  for (RiskPath& path : postures.best(search.start, search.goal, parameters_.postures,
                                      parameters_.kept_postures, search.deadline, ~search.seed)) {
    paths->push_back(std::move(path));
  }
}

void RiskPlanner::improve(const Search& search, int attempts, std::size_t first, std::size_t last,
                          std::vector<RiskPath>* paths) const {
  parallelFor(last - first, [&](std::size_t i) {
    CounterRandom random(mixBits(search.seed, mixBits(attempts, i)));
    (*paths)[first + i].improve(search.space, attempts, kMoveDistance * search.unit,
                                search.deadline, &random);
  });
}

// The paths, and then those of earlier searches for which there was no time.
void RiskPlanner::remember(const std::vector<RiskPath>& paths) {
  std::vector<std::vector<RiskState>> known;
  for (const RiskPath& path : paths) {
    if (path.states().size() > 2) known.push_back(path.states());
  }
  std::move(alternatives_.begin(), alternatives_.end(), std::back_inserter(known));
  known.resize(std::min(known.size(), static_cast<std::size_t>(parameters_.alternatives)));
  alternatives_ = std::move(known);
}

std::vector<RiskPath> RiskPlanner::climb(Search* search) const {
  std::vector<RiskPath> paths;
  Trees trees = plant(*search);  // what one rung allows, the next allows too
  const auto late = [&] { return !paths.empty() && search->deadline.passed(); };
  for (const double rung : kRungs) {
    const int limit = static_cast<int>(rung * kHypotheses);
    // Not into what touches for sure, in order to pass beside.
    if (search->motions.barsPlaces() && limit == kHypotheses) break;
    for (int k = 0; k < parameters_.paths && !late(); ++k) {
      if (!paths.empty()) trees = plant(*search);
      auto states = connect(&trees, limit, search);
      if (!states) break;
      paths.emplace_back(search->motions, search->measure, std::move(*states));
      paths.back().improve(search->space, parameters_.improvements, kMoveDistance * search->unit,
                           search->deadline, &search->random);
    }
    if (static_cast<int>(paths.size()) >= parameters_.paths || late()) break;
  }
  if (keep_tree_) keepEdges(trees, search);
  return paths;
}

void RiskPlanner::keepEdges(const Trees& trees, Search* search) const {
  for (const RiskTree* tree : {&trees.from_start, &trees.from_goal}) {
    for (int node = 0; node < tree->size(); ++node) {
      const int parent = tree->parent(node);
      if (parent < 0) continue;
      search->edges.push_back({search->space.toPose(tree->state(parent)).translation(),
                               search->space.toPose(tree->state(node)).translation()});
    }
  }
}

RiskPlanner::Trees RiskPlanner::plant(const Search& search) const {
  Trees trees{RiskTree(search.motions, search.step), RiskTree(search.motions, search.step)};
  trees.from_start.add(search.start, -1);
  trees.from_goal.add(search.goal, -1);
  plantTracks(search.worlds->tracks, search.space, search.worlds->free.parameters(), search.motions,
              search.step, &trees.from_start);
  return trees;
}

RiskState RiskPlanner::draw(const RiskTree& tree, Search* search) const {
  CounterRandom* random = &search->random;
  const RiskSpace& space = search->space;
  const double choice = random->uniform();
  if (choice >= kLocalShare) return space.sample(random);
  const RiskState& center = tree.state(random->index(tree.size()));
  const double units = choice < kNearShare ? kNear : kWide;
  const double distance = units * search->unit;
  const double angle = units * kRadiansPerUnit;
  return random->uniform() < 0.5 ? space.sampleAlongAxis(center, distance, angle, random)
                                 : space.sampleNear(center, distance, angle, random);
}

std::optional<std::vector<RiskState>> RiskPlanner::connect(Trees* trees, int limit,
                                                           Search* search) const {
  for (int i = 0; i < parameters_.iterations; ++i) {
    // Where everything is allowed, the trees meet at once.
    if (limit < kHypotheses && search->deadline.passed()) return std::nullopt;
    RiskTree& grown = i % 2 == 0 ? trees->from_start : trees->from_goal;
    RiskTree& other = i % 2 == 0 ? trees->from_goal : trees->from_start;
    const RiskState sample = draw(grown, search);
    if (!search->space.contains(sample)) continue;
    const RiskTree::Extension extension = grown.extend(sample, limit);
    if (extension.growth == RiskTree::Growth::kNone) continue;
    const RiskState target = grown.state(extension.node);
    RiskTree::Extension bridge{RiskTree::Growth::kStep, 0};
    for (int n = 0; n < kLongestConnection && bridge.growth == RiskTree::Growth::kStep; ++n) {
      bridge = other.extend(target, limit);
    }
    if (bridge.growth != RiskTree::Growth::kReached) continue;
    std::vector<RiskState> states = grown.branch(extension.node);
    std::vector<RiskState> rest = other.branch(bridge.node);
    states.insert(states.end(), rest.rbegin() + 1, rest.rend());
    if (i % 2 != 0) std::reverse(states.begin(), states.end());
    return states;
  }
  return std::nullopt;
}

}  // namespace smore
