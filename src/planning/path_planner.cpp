// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/path_planner.h"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>

#include <memory>
#include <mutex>
#include <sstream>
#include <stdexcept>

#include "motion_state_space.h"
#include "nearest_forest.h"
#include "smore/common/deadline.h"

namespace smore {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

// Poses nearer than this [m + rad] are one pose but for rounding.
constexpr double kSamePose = 1e-9;

void silenceOmpl() {
  static std::once_flag silenced;
  std::call_once(silenced, [] { ompl::msg::noOutputHandler(); });
}

/// Motions judged by the caller.
class CallerMotionValidator : public ob::MotionValidator {
 public:
  CallerMotionValidator(const ob::SpaceInformationPtr& information, const MotionStateSpace& space,
                        const MotionSpace& allowed, const MotionValidity& valid)
      : MotionValidator(information), space_(space), allowed_(allowed), valid_(valid) {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    const Pose begin = space_.toPose(from);
    const Pose end = space_.toPose(to);
    return allowed_.allowsTurn(begin, end) && valid_(begin, end);
  }

  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& last_valid) const override {
    if (checkMotion(from, to)) return true;
    last_valid.second = 0.0;
    if (last_valid.first != nullptr) si_->copyState(last_valid.first, from);
    return false;
  }

 private:
  const MotionStateSpace& space_;
  const MotionSpace& allowed_;
  const MotionValidity& valid_;
};

/// OMPL's RRT with its random decisions (when to sample the goal) drawn from a seed.
class SeededRrt : public og::RRT {
 public:
  SeededRrt(const ob::SpaceInformationPtr& information, std::uint32_t seed) : RRT(information) {
    rng_.setLocalSeed(seed);
  }
};

/// Ends a search after so many samples or so much time.
class Budget {
 public:
  explicit Budget(const PathPlannerParameters& parameters)
      : parameters_(parameters), deadline_(parameters.time_limit_s) {}

  /// To be asked once for each sample.
  bool isUsedUp() {
    if (++asked_ > parameters_.max_iterations) return true;
    timed_out_ = timed_out_ || deadline_.passed();
    return timed_out_;
  }

  std::string reason() const {
    std::ostringstream text;
    if (timed_out_) {
      text << "no path to the goal within the time limit of " << parameters_.time_limit_s << " s";
    } else {
      text << "no path to the goal after " << parameters_.max_iterations << " samples";
    }
    return text.str();
  }

 private:
  PathPlannerParameters parameters_;
  Deadline deadline_;
  int asked_ = 0;
  bool timed_out_ = false;
};

/// One search: the OMPL objects of a single call.
class Search {
 public:
  Search(const MotionStateSpace& space, const PathPlannerParameters& parameters, std::uint32_t seed,
         const MotionSpace& allowed, const StateValidity& valid, const MotionValidity& motion_valid)
      : space_(space),
        parameters_(parameters),
        information_(std::make_shared<ob::SpaceInformation>(space.ompl())) {
    information_->setStateValidityChecker([&space, &allowed, &valid](const ob::State* state) {
      const Pose pose = space.toPose(state);
      return allowed.inWorkspace(pose) && valid(pose);
    });
    information_->setMotionValidator(
        std::make_shared<CallerMotionValidator>(information_, space, allowed, motion_valid));
    information_->setup();
    planner_ = makePlanner(seed);
  }

  Result<Path> run(const Pose& start, const Pose& goal) {
    auto problem = std::make_shared<ob::ProblemDefinition>(information_);
    ob::ScopedState<> from(space_.ompl());
    ob::ScopedState<> to(space_.ompl());
    space_.fromPose(start, from.get());
    space_.fromPose(goal, to.get());
    problem->setStartAndGoalStates(from, to);
    planner_->setProblemDefinition(problem);
    Budget budget(parameters_);
    const ob::PlannerTerminationCondition until([&budget] { return budget.isUsedUp(); });
    if (planner_->solve(until) != ob::PlannerStatus::EXACT_SOLUTION) {
      return Failure{budget.reason()};
    }
    return toPath(*problem->getSolutionPath()->as<og::PathGeometric>(), start, goal);
  }

  std::vector<TreeEdge> tree() const {
    ob::PlannerData data(information_);
    planner_->getPlannerData(data);
    std::vector<TreeEdge> edges;
    for (unsigned int from = 0; from < data.numVertices(); ++from) {
      std::vector<unsigned int> ends;
      data.getEdges(from, ends);
      for (const unsigned int to : ends) edges.push_back({origin(data, from), origin(data, to)});
    }
    return edges;
  }

 private:
  Vec3 origin(const ob::PlannerData& data, unsigned int vertex) const {
    return space_.toPose(data.getVertex(vertex).getState()).translation();
  }

  ob::PlannerPtr makePlanner(std::uint32_t seed) const {
    if (parameters_.algorithm == PlannerAlgorithm::kRrtConnect) {
      auto planner = std::make_shared<og::RRTConnect>(information_);
      planner->setRange(parameters_.step);
      planner->setNearestNeighbors<NearestForest>();
      return planner;
    }
    auto planner = std::make_shared<SeededRrt>(information_, seed);
    planner->setRange(parameters_.step);
    planner->setGoalBias(parameters_.goal_bias);
    planner->setNearestNeighbors<NearestForest>();
    return planner;
  }

  /// The ends are the caller's own poses, not their images in OMPL's coordinates.
  Path toPath(const og::PathGeometric& solution, const Pose& start, const Pose& goal) const {
    Path path = {start};
    for (std::size_t i = 1; i + 1 < solution.getStateCount(); ++i) {
      path.push_back(space_.toPose(solution.getState(i)));
    }
    path.push_back(goal);
    return path;
  }

  const MotionStateSpace& space_;
  PathPlannerParameters parameters_;
  ob::SpaceInformationPtr information_;
  ob::PlannerPtr planner_;
};

/// Why a pose cannot begin or end a path; empty where it can.
std::string refusal(const std::string& name, const Pose& pose, const MotionSpace& space,
                    const StateValidity& valid) {
  if (!isFinite(pose)) return "the " + name + " is not finite";
  const std::string outside = space.whyOutside(pose);
  if (!outside.empty()) return "the " + name + " " + outside;
  if (valid(pose)) return "";
  return "the " + name + " " + describe(pose.translation()) + " is in collision";
}

void check(const PathPlannerParameters& parameters) {
  const bool sound = parameters.step > 0.0 && parameters.goal_bias >= 0.0 &&
                     parameters.goal_bias <= 1.0 && parameters.max_iterations >= 1 &&
                     parameters.time_limit_s > 0.0;
  if (!sound) throw std::invalid_argument("a parameter of the path planner is out of its range");
}

}  // namespace

PathPlanner::PathPlanner(const MotionSpace& space, const PathPlannerParameters& parameters,
                         std::uint32_t seed)
    : space_(space), parameters_(parameters), seed_(seed) {
  check(parameters);
}

Result<Path> PathPlanner::plan(const Pose& start, const Pose& goal, const StateValidity& valid,
                               const CheckResolution& resolution) {
  return plan(start, goal, valid, [&](const Pose& from, const Pose& to) {
    const Path poses = densify({from, to}, resolution.distance, resolution.angle);
    return std::all_of(poses.begin() + 1, poses.end(), valid);
  });
}

Result<Path> PathPlanner::plan(const Pose& start, const Pose& goal, const StateValidity& valid,
                               const MotionValidity& motion_valid) {
  silenceOmpl();
  tree_.clear();
  for (const auto& [name, pose] :
       {std::make_pair("start", space_.moved(start)), std::make_pair("goal", goal)}) {
    const std::string reason = refusal(name, pose, space_, valid);
    if (!reason.empty()) return Failure{reason};
  }
  if (gapBetween(start, goal) <= kSamePose) return Path{start, goal};
  const MotionStateSpace states(space_, seed_);
  Search search(states, parameters_, seed_, space_, valid, motion_valid);
  Result<Path> path = search.run(start, goal);
  if (keep_tree_) tree_ = search.tree();
  return path;
}

}  // namespace smore
