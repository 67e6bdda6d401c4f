// SPDX-License-Identifier: BSD-3-Clause
#include "smore/experiment/contact_place.h"

#include <cmath>

namespace smore {
namespace {

constexpr double kSurfaceTolerance = 0.005;  // compliance of a contact and the meeting of two edges

double normalDensity(double distance, double stddev) {
  const double scaled = distance / stddev;
  return std::exp(-0.5 * scaled * scaled) / (stddev * std::sqrt(2.0 * M_PI));
}

}  // namespace

std::optional<Vec3> truePlace(const ContactObservation& contact, const TrialTruth& truth) {
  const auto points = truth.contacts.find(contact.contact_id);
  if (points == truth.contacts.end()) return std::nullopt;
  Vec3 force = Vec3::Zero();
  for (const ContactPoint& point : points->second) force += point.force;
  Vec3 mean = Vec3::Zero();
  double sum = 0.0;
  for (const ContactPoint& point : points->second) {
    const double weight = point.force.dot(force);
    mean += weight * point.position;
    sum += weight;
  }
  if (!(sum > 0.0)) return std::nullopt;
  mean /= sum;
  const Vec3 on_object = contact.T_world_object.inverse() * mean;
  const bool on_surfaces = std::abs(signedDistance(truth.environment, mean)) <= kSurfaceTolerance &&
                           std::abs(signedDistance(truth.object, on_object)) <= kSurfaceTolerance;
  if (!on_surfaces) return std::nullopt;
  return on_object;
}

double logPlaceDensity(const std::vector<std::optional<Vec3>>& places, const LineOfAction& line,
                       const Vec3& true_place, double bandwidth, double range, bool planar) {
  Vec3 direction = line.direction;
  if (planar) direction.z() = 0.0;
  direction.normalize();
  double density = 1.0 / range;
  for (const std::optional<Vec3>& place : places) {
    density += place ? normalDensity((true_place - *place).dot(direction), bandwidth) : 1.0 / range;
  }
  return std::log(density / (static_cast<double>(places.size()) + 1.0));
}

}  // namespace smore
