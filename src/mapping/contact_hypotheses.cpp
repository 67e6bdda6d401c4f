// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/contact_hypotheses.h"

#include <cmath>
#include <cstring>

#include "smore/mapping/counter_random.h"

namespace smore {
namespace {

// A line that is steeper than 60 degrees to the plane of motion does not come from moving in it.
constexpr double kSmallestInPlane = 0.5;

std::uint64_t hashOf(const Vec3& vector, std::uint64_t seed) {
  for (int axis = 0; axis < 3; ++axis) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &vector[axis], sizeof(bits));
    seed = mixBits(seed, bits);
  }
  return seed;
}

std::uint64_t hashOf(const Pose& T_map_object, const LineOfAction& line) {
  std::uint64_t hash = hashOf(line.point, hashOf(line.direction, 0));
  hash = hashOf(T_map_object.translation(), hash);
  return hashOf(T_map_object.linear().col(0), hashOf(T_map_object.linear().col(1), hash));
}

void normalise(std::array<float, kCandidates>* log_prior, int count) {
  double sum = 0.0;
  for (int i = 0; i < count; ++i) sum += std::exp((*log_prior)[i]);
  for (int i = 0; i < count; ++i) (*log_prior)[i] -= static_cast<float>(std::log(sum));
}

}  // namespace

void PointArray::set(int i, const Vec3& point) {
  x[i] = static_cast<float>(point.x());
  y[i] = static_cast<float>(point.y());
  z[i] = static_cast<float>(point.z());
}

std::optional<ContactHypotheses> contactHypotheses(const Pose& T_map_object,
                                                   const LineOfAction& line,
                                                   const FeatureParameters& parameters,
                                                   bool planar) {
  Vec3 direction = line.direction;
  Vec3 foot = line.point;
  if (planar) {
    direction.z() = 0.0;
    if (!(direction.norm() >= kSmallestInPlane)) return std::nullopt;
    direction.normalize();
    foot.z() = 0.0;
    foot -= foot.dot(direction) * direction;
  }
  ContactHypotheses result;
  result.id = hashOf(T_map_object, line);
  result.object_normal = direction;
  result.world_normal = T_map_object.linear() * direction;
  result.direction_stddev = line.direction_stddev;
  const double spacing = 2.0 * parameters.reach / kCandidates;
  for (int i = 0; i < kCandidates; ++i) {
    const Vec3 place = foot + (i + 0.5 - 0.5 * kCandidates) * spacing * direction;
    const Vec3 object = place + parameters.radius * direction;
    if (place.norm() > parameters.reach) continue;
    result.object.set(result.count, object);
    result.world.set(result.count, T_map_object * Vec3(place - parameters.radius * direction));
    result.log_prior[result.count] = static_cast<float>(-object.norm() / parameters.decay);
    ++result.count;
  }
  if (result.count == 0) return std::nullopt;
  normalise(&result.log_prior, result.count);
  return result;
}

}  // namespace smore
