// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "smore/common/robot.h"
#include "smore/planning/planner.h"
#include "smore/planning/risk_calibration.h"
#include "smore/retrieval/motion_observer.h"
#include "smore/scenario/scenario.h"

namespace smore {

struct RetrievalParameters {
  Pose start = Pose::Identity();          ///< T_world_object
  Pose goal = Pose::Identity();           ///< T_world_object
  double goal_position_tolerance = 0.02;  ///< [m]
  double goal_angle_tolerance = 0.1;      ///< [rad]
  Motion motion = Motion::kPlanar;        ///< for RiskCalibration
  OnContact on_contact = OnContact::kReset;
  double retreat_distance = 0.05;  ///< how far to back off after a contact [m + rad], positive
  int max_collisions = 2000;       ///< gives up at so many, at least 1
  /// Gives up after so many plans in a row without a path, or with one that the robot refuses; at
  /// least 1.
  int max_failed_plans = 20;
};

/// The parameters that the scenario fixes; the others keep their defaults.
RetrievalParameters retrievalParameters(const Scenario& scenario);

/// Whether a pose is at the goal, within the tolerances.
bool isAtGoal(const RetrievalParameters& parameters, const Pose& T_world_object);

enum class Phase { kPlanning, kMoving, kResetting, kRetreating, kFinished };

/// The phase in one word, for people.
const char* phaseName(Phase phase);

struct RetrievalProgress {
  Phase phase = Phase::kPlanning;
  int collisions = 0;
  int plans = 0;      ///< planning calls so far, successful or not
  double risk = 0.0;  ///< of the present plan, corrected (RiskCalibration), in [0, 1]
};

/// A planned motion that was made to its end or to a contact.
struct PlannedMotion {
  double risk = 0.0;     ///< probability of a contact that was stated before, in [0, 1]
  bool touched = false;  ///< whether a contact ended it
};

struct RetrievalOutcome {
  bool success = false;
  std::string reason;  ///< why it ended, in words for the user
  int collisions = 0;  ///< confirmed contacts during commanded motion; retreats do not count
  int plans = 0;
  double path_length = 0.0;  ///< executed in the last attempt [m]
  double planning_s = 0.0;   ///< wall time [s]
  Path path;  ///< last planned path, from start to goal; empty if none was ever found
  std::vector<PlannedMotion> motions;  ///< in the order in which they were made
};

/// The loop: plan, move, stop at contact, learn, and again (paper, section III-C). It knows nothing
/// of how contacts are sensed or maps are kept: the robot returns from a motion when both have been
/// done.
class Retrieval {
 public:
  using ProgressCallback = std::function<void(const RetrievalProgress&)>;

  /// `robot` and `planner` must outlive this. `on_progress` is called at each change of phase, from
  /// the thread of `run`; it may be empty. `motions` may be null and must outlive this.
  Retrieval(const RetrievalParameters& parameters, Robot* robot, Planner* planner,
            ProgressCallback on_progress, MotionObserver* motions = nullptr);

  /// Runs until the goal, the collision limit, a fault, or `requestStop`. It does not move where
  /// the object is at the goal already, and after the last collision it backs off.
  RetrievalOutcome run();

  /// Ends `run` at the next change of phase; from any thread. The robot's own stop is the caller's.
  void requestStop() { stop_requested_ = true; }

 private:
  bool atGoal() const;
  std::string missedGoal() const;
  /// Whether the user asked for the end, which is now.
  bool stopped();
  void enter(Phase phase);
  /// A path from where the robot is; resets to the start where there is none from elsewhere, but
  /// stays where the planner cannot be asked.
  bool findPlan(Plan* plan);
  /// True if the retrieval is over.
  bool execute(const Plan& plan);
  MotionResult follow(const Plan& plan);
  void noteRefusal(const MotionResult& motion);
  bool recover();
  bool finish(bool success, const std::string& reason);

  RetrievalParameters parameters_;
  Robot* robot_;
  Planner* planner_;
  ProgressCallback on_progress_;
  MotionObserver* motions_;
  RetrievalProgress progress_;
  RetrievalOutcome outcome_;
  RiskCalibration calibration_{parameters_.motion};
  double planned_risk_ = 0.0;     ///< of the present plan, as the planner stated it
  int refused_ = 0;               ///< paths in a row that the robot could not follow
  std::vector<Pose> refused_at_;  ///< where these could not be followed from here
  int missed_ = 0;                ///< motions in a row that ended beside the goal
  Pose last_contact_pose_ = Pose::Identity();
  std::atomic<bool> stop_requested_{false};
};

}  // namespace smore
