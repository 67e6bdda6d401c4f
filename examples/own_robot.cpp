// SPDX-License-Identifier: BSD-3-Clause
// A robot of one's own in the retrieval loop. This one moves a mere point around a round wall; a
// real one asks its controller to move and its sensor for the force.
#include <smore/retrieval/method.h>
#include <smore/retrieval/retrieval.h>

#include <iostream>

using namespace smore;

class PointRobot : public Robot {
 public:
  explicit PointRobot(ContactObserver* maps, const Pose& start) : maps_(maps), pose_(start) {}
  Pose pose() const override { return pose_; }
  MotionResult follow(const Path& path) override {
    for (const Pose& next : densify(path, 0.002, 0.05)) {  // 2 mm, 3 degrees
      const Vec3 outwards = next.translation() - kWall;
      if (outwards.norm() < kRadius) return touch(outwards.normalized());
      pose_ = next;
      tell(ContactState::kFree, {});
    }
    return {};
  }
  MotionResult retreat(double /*distance*/) override { return reset(start_); }
  MotionResult reset(const Pose& start) override {
    pose_ = start;
    return {};
  }

 private:
  MotionResult touch(const Vec3& outwards) {
    ++contacts_;
    const Vec3 force_object = 10.0 * (pose_.linear().transpose() * outwards);
    tell(ContactState::kContact, *lineOfAction({force_object, Vec3::Zero()}, 1.0));
    return {MotionEnd::kContact};
  }
  void tell(ContactState state, const std::optional<LineOfAction>& line) {
    maps_->observe({0.01 * ++steps_, pose_, state, contacts_, line});
  }

  const Vec3 kWall{0.3, 0.0, 0.0};
  const double kRadius = 0.12;
  ContactObserver* maps_;
  Pose pose_;
  Pose start_ = pose_;
  int contacts_ = 0, steps_ = 0;
};

int main() {
  Scenario task;  // what is known beforehand; no shapes
  task.goal = makePose({0.6, 0.0, 0.0});
  task.workspace = {{-0.2, -0.5, -0.1}, {0.8, 0.5, 0.1}};
  Method method = makeMethod(MethodKind::kSmore, task, 1);
  PointRobot robot(method.maps.get(), task.start);
  Retrieval retrieval(retrievalParameters(task), &robot, method.planner.get(), {});
  const RetrievalOutcome outcome = retrieval.run();
  std::cout << outcome.reason << " after " << outcome.collisions << " touches\n";
  return outcome.success ? 0 : 1;
}
