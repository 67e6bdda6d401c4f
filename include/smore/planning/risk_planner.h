// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "smore/mapping/counter_random.h"
#include "smore/mapping/joint_belief.h"
#include "smore/planning/planner.h"
#include "smore/planning/risk_path.h"
#include "smore/planning/risk_space.h"
#include "smore/planning/risk_tree.h"
#include "smore/scenario/motion_space.h"

namespace smore {

struct RiskPlannerParameters {
  int iterations = 1500;   ///< samples for each tree on each rung of the ladder of risk, at least 1
  int paths = 4;           ///< paths of which the best is taken, at least 1
  int improvements = 120;  ///< changes tried on each path in a plane
  int improvements_in_space = 12;  ///< in space, where more fit it to the worlds' errors
  int postures = 500;              ///< in space: ways in another posture that are tried
  int kept_postures = 4;           ///< the best of them, which are improved
  int alternatives = 12;           ///< in space: paths of earlier searches that are looked at anew
  /// Wall time of a search after which the best path so far is taken; where there is none yet, one
  /// at any risk [s].
  double time_limit = 3600.0;
  /// In units of length: longest edge of the trees, in the metric of the search ...
  double step = 1.2;
  /// ... and what a radian counts in it: half of the reach of what is held, in units of that.
  double lever = 3.0;
  RiskObjective objective;
  /// In space: the share of the contacts so far that came of matter that nobody knew of
  /// (SweptRoom); none are in a plane. Our choice, on tuning seeds.
  double surprise_share_in_space = 0.2;
  /// In space: as many such contacts at least where the object is known beforehand, at least 0: its
  /// matter is no guess, so that what it sweeps is known from the first motion on. Our choice, on
  /// tuning seeds.
  double surprises_of_known_object = 2.0;
};

/// Least risk first, then length: bidirectional trees in the states whose risk stays below a limit,
/// the limit raised rung by rung until there are paths; in space also ways in another posture, and
/// the best paths of earlier searches. Of these, improved by shortcuts and moves, the one with the
/// best objective over the joint samples (docs/planning.md (P3)). There is always a path unless
/// start or goal lie outside of the workspace: at the last rung everything is allowed. Places to
/// avoid are passed at a step of the trees, or at half of their distance from start and goal, where
/// the search finds such a way that does not touch in all worlds; looking for one may take as long
/// as the search without.
///
/// The same seed and the same calls give the same paths, unless the time limit ends a search.
class RiskPlanner : public Planner {
 public:
  /// `belief` is a view.
  RiskPlanner(const JointBelief& belief, const MotionSpace& space,
              const RiskPlannerParameters& parameters, std::uint64_t seed);

  Result<Plan> plan(const Pose& start, const Pose& goal) override;

 private:
  struct Search;
  struct Trees;
  /// A plan that does not pass these places.
  Result<Plan> planBeside(const std::vector<Pose>& refused, const Pose& start, const Pose& goal);
  void remember(const std::vector<RiskPath>& paths);
  std::vector<RiskPath> climb(Search* search) const;
  /// Touches that are taken to have come of matter that nobody knew of.
  double surprisesIn(const Worlds& worlds) const;
  void searchFurther(const Search& search, std::vector<RiskPath>* paths);
  void addAlternatives(const Search& search, std::vector<RiskPath>* paths);
  void addPostures(const Search& search, std::vector<RiskPath>* paths) const;
  void improve(const Search& search, int attempts, std::size_t first, std::size_t last,
               std::vector<RiskPath>* paths) const;
  Trees plant(const Search& search) const;
  std::optional<std::vector<RiskState>> connect(Trees* trees, int limit, Search* search) const;
  RiskState draw(const RiskTree& tree, Search* search) const;
  void keepEdges(const Trees& trees, Search* search) const;

  const JointBelief* belief_;
  RiskPlannerParameters parameters_;
  MotionSpace space_;
  std::uint64_t seed_;
  std::uint64_t calls_ = 0;
  std::vector<std::vector<RiskState>> alternatives_;  ///< best first
};

}  // namespace smore
