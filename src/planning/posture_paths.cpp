// SPDX-License-Identifier: BSD-3-Clause
#include "smore/planning/posture_paths.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "smore/common/parallel_for.h"

namespace smore {
namespace {

constexpr double kQuarterShare = 0.5;

// Parts of the work for the processor's cores. What comes out does not depend on their number.
constexpr int kParts = 8;

// A posture at one end that lies outside of the workspace is drawn in by such steps of its shift.
constexpr float kShrink = 0.1F;

// The best of many, by their value.
class Best {
 public:
  explicit Best(int count) : count_(count) {}

  /// What a path must be below to be one of them.
  double limit() const {
    return static_cast<int>(paths_.size()) < count_ ? std::numeric_limits<double>::infinity()
                                                    : paths_.back().value();
  }

  void offer(RiskPath path) {
    if (path.value() >= limit()) return;
    const auto after = std::upper_bound(paths_.begin(), paths_.end(), path, isBetter);
    paths_.insert(after, std::move(path));
    if (static_cast<int>(paths_.size()) > count_) paths_.pop_back();
  }

  const std::vector<RiskPath>& paths() const { return paths_; }

 private:
  int count_;
  std::vector<RiskPath> paths_;
};

}  // namespace

PosturePaths::PosturePaths(const RiskMotions& motions, const RiskSpace& space,
                           const PathValue& measure)
    : motions_(&motions), space_(space), measure_(measure) {}

std::vector<RiskPath> PosturePaths::best(const RiskState& start, const RiskState& goal, int tried,
                                         int kept, const Deadline& deadline,
                                         std::uint64_t seed) const {
  std::vector<Best> parts(kParts, Best(kept));
  parallelFor(kParts, [&](std::size_t part) {
    for (int i = static_cast<int>(part); i < tried && !deadline.passed(); i += kParts) {
      CounterRandom random(mixBits(seed, i));
      std::vector<RiskState> states = draw(start, goal, &random);
      if (states.empty() || !mayBeBelow(parts[part].limit(), states)) continue;
      parts[part].offer(RiskPath(*motions_, measure_, std::move(states)));
    }
  });
  Best all(kept);
  for (const Best& part : parts) {
    for (const RiskPath& path : part.paths()) all.offer(path);
  }
  return all.paths();
}

std::vector<RiskState> PosturePaths::draw(const RiskState& start, const RiskState& goal,
                                          CounterRandom* random) const {
  const RiskState any = space_.sample(random);
  const double share = random->uniform();
  const Eigen::Vector3f shift = static_cast<float>(share * share) * (any.position - start.position);
  const Eigen::Quaternionf rotation = turned(start, any, random);
  std::vector<RiskState> states = {start};
  for (const RiskState& end : {start, goal}) {
    float part = 1.0F;
    RiskState state{end.position + shift, rotation};
    while (!space_.contains(state) && part > 0.0F) {
      part -= kShrink;
      state.position = end.position + part * shift;
    }
    if (part <= 0.0F) return {};
    states.push_back(state);
  }
  states.push_back(goal);
  return states;
}

Eigen::Quaternionf PosturePaths::turned(const RiskState& start, const RiskState& any,
                                        CounterRandom* random) const {
  if (random->uniform() >= kQuarterShare) return any.rotation;
  const auto about = [&](const Eigen::Vector3f& axis) {
    return Eigen::Quaternionf(
        Eigen::AngleAxisf(static_cast<float>(M_PI_2) * static_cast<float>(random->index(4)), axis));
  };
  const Eigen::Quaternionf turn = about(Eigen::Vector3f::UnitZ());
  const Eigen::Quaternionf pitch = about(Eigen::Vector3f::UnitY());
  const Eigen::Quaternionf roll = about(Eigen::Vector3f::UnitX());
  return roll * pitch * turn * start.rotation;
}

// By the middle motion alone, where most of them fail.
bool PosturePaths::mayBeBelow(double limit, const std::vector<RiskState>& states) const {
  const double turns =
      motions_->distance(states[0], states[1]) + motions_->distance(states[2], states[3]);
  const PathValue::Along value = measure_.along(states);
  const auto hopeless = [&](const MotionCost& part) { return turns + value.of(part) > limit; };
  return motions_->costUnless(states[1], states[2], hopeless).has_value();
}

}  // namespace smore
