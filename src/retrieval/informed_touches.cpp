// SPDX-License-Identifier: BSD-3-Clause
#include "smore/retrieval/informed_touches.h"

#include <algorithm>
#include <cmath>

#include "smore/planning/contact_risk.h"
#include "smore/planning/free_roadmap.h"

namespace smore {
namespace {

Vec3 unitVector(CounterRandom* random) {
  while (true) {
    const Vec3 vector = random->inCube();
    const double norm = vector.norm();
    if (norm > 0.1 && norm <= 1.0) return vector / norm;
  }
}

}  // namespace

InformedTouches::InformedTouches(const JointBelief& belief, const MotionSpace& space,
                                 const InformedTouchParameters& parameters, std::uint64_t seed)
    : belief_(&belief),
      space_(space),
      parameters_(parameters),
      first_(space, seed),
      random_(seed) {}

Result<Path> InformedTouches::nextTouch(const Pose& from) {
  if (belief_->contactCount() == 0) return first_.nextTouch(from);
  const ContactRisk risk(belief_->worlds());
  const FreeRoadmap roadmap(tracksWithin(space_, risk.worlds().tracks), from,
                            risk.worlds().free.parameters(), risk.worlds().unit);
  int best_turn = 0;
  Pose best_end = from;
  information_ = 0.0;
  for (int i = 0; i < parameters_.probes; ++i) {
    const int turn = random_.index(static_cast<int>(roadmap.reachable().size()));
    const Pose& begin = roadmap.reachable()[turn];
    const Pose end = drawEnd(begin, risk.worlds().held, &random_);
    if (!space_.inWorkspace(end) || !space_.allowsTurn(begin, end)) continue;
    const double information = risk.informationOf({begin, end});
    if (information <= information_) continue;
    information_ = information;
    best_turn = turn;
    best_end = end;
  }
  if (information_ < parameters_.least_information) return Path();
  Path path = roadmap.routeTo(best_turn);
  path.push_back(best_end);
  return path;
}

// A straight way and a turn about one axis: together of the least length, with the way stretched.
Pose InformedTouches::drawEnd(const Pose& from, double held, CounterRandom* random) const {
  const double share = random->uniform();
  const double angle =
      random->symmetric() * (1.0 - share) * parameters_.probe_length / parameters_.lever;
  Vec3 direction = unitVector(random);
  Vec3 axis = unitVector(random);
  if (space_.motion == Motion::kPlanar) {
    const double heading = M_PI * random->symmetric();
    direction = space_.T_world_plane.linear() * Vec3(std::cos(heading), std::sin(heading), 0.0);
    axis = space_.T_world_plane.linear().col(2);
  }
  const double shortest = parameters_.probe_length * held;
  const double longest = std::max(shortest, (space_.workspace.max - space_.workspace.min).norm());
  const double length = shortest * std::pow(longest / shortest, random->uniform());
  Pose end = space_.moved(from);
  end.translation() += share * length * direction;
  end.linear() = Eigen::AngleAxisd(angle, axis).toRotationMatrix() * end.linear();
  return end;
}

}  // namespace smore
