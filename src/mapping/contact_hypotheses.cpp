// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/contact_hypotheses.h"

#include <algorithm>
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

// `count` is positive.
void normalise(std::array<float, kCandidates>* log_prior, int count) {
  const double largest = *std::max_element(log_prior->begin(), log_prior->begin() + count);
  double sum = 0.0;
  for (int i = 0; i < count; ++i) sum += std::exp((*log_prior)[i] - largest);
  const auto log_sum = static_cast<float>(largest + std::log(sum));
  for (int i = 0; i < count; ++i) (*log_prior)[i] -= log_sum;
}

// Four standard normal numbers at a time that fill their space evenly: Roberts' sequence in four
// dimensions, from a random start, by the method of Box and Muller.
class EvenNormals {
 public:
  explicit EvenNormals(std::uint64_t seed) {
    CounterRandom random(seed);
    for (double& value : at_) value = random.uniform();
  }

  Eigen::Vector4d next() {
    constexpr double kRatio = 1.16730397826141868;  // root of x^5 = x + 1
    double step = 1.0;
    for (double& value : at_) {
      step /= kRatio;
      value += step;
      value -= std::floor(value);
    }
    const double first = std::sqrt(-2.0 * std::log1p(-at_[0]));
    const double second = std::sqrt(-2.0 * std::log1p(-at_[1]));
    const double a = 2.0 * M_PI * at_[2];
    const double b = 2.0 * M_PI * at_[3];
    return {first * std::cos(a), first * std::sin(a), second * std::cos(b), second * std::sin(b)};
  }

 private:
  std::array<double, 4> at_{};
};

// A line where it may have been: through `foot` along `direction`, both in the object frame.
struct Ray {
  Vec3 foot;
  Vec3 direction;
};

// The line as the plane has it: seen from where the object is in the plane, and without its height.
// Nothing for a line that is too steep.
std::optional<Ray> inPlane(const Pose& T_plane_object, const LineOfAction& line) {
  const Pose T_flat_object = projectedToPlane(T_plane_object).inverse() * T_plane_object;
  Ray ray{T_flat_object * line.point, T_flat_object.linear() * line.direction};
  ray.direction.z() = 0.0;
  if (!(ray.direction.norm() >= kSmallestInPlane)) return std::nullopt;
  ray.direction.normalize();
  ray.foot.z() = 0.0;
  ray.foot -= ray.foot.dot(ray.direction) * ray.direction;
  return ray;
}

// The lines that one measured line may stand for.
class UncertainLine {
 public:
  UncertainLine(const Ray& mean, const LineOfAction& line, std::uint64_t seed, bool planar)
      : mean_(mean),
        across_(planar ? Vec3(-mean.direction.y(), mean.direction.x(), 0.0)
                       : Vec3(mean.direction.unitOrthogonal())),
        up_(planar ? Vec3(Vec3::Zero()) : Vec3(mean.direction.cross(across_))),
        offset_stddev_(std::hypot(line.offset_stddev, line.pitch)),
        direction_stddev_(line.direction_stddev),
        normals_(seed) {}

  /// How far from the mean line a place may be, `reach` away along it.
  double spread(double reach) const {
    return std::hypot(offset_stddev_, reach * direction_stddev_);
  }

  Ray next() {
    const Eigen::Vector4d normal = normals_.next();
    const Vec3 shift = normal[0] * across_ + normal[1] * up_;
    const Vec3 tilt = normal[2] * across_ + normal[3] * up_;
    return {mean_.foot + offset_stddev_ * shift,
            (mean_.direction + direction_stddev_ * tilt).normalized()};
  }

 private:
  Ray mean_;
  Vec3 across_;
  Vec3 up_;
  double offset_stddev_;
  double direction_stddev_;
  EvenNormals normals_;
};

void addPlace(const Pose& T_map_object, const Vec3& place, const Vec3& normal,
              const FeatureParameters& parameters, ContactHypotheses* result) {
  const double distance = place.norm();
  if (std::isnan(distance) || distance > parameters.reach) return;  // a line may lack a direction
  const Vec3 object = place + parameters.radius * normal;
  const int i = result->count++;
  result->object.set(i, object);
  result->world.set(i, T_map_object * Vec3(place - parameters.radius * normal));
  result->object_normal.set(i, normal);
  result->world_normal.set(i, T_map_object.linear() * normal);
  result->log_prior[i] = static_cast<float>(-object.norm() / parameters.decay);
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
  if (!isFinite(T_map_object) || !isFinite(line)) return std::nullopt;
  const Pose T = planar ? projectedToPlane(T_map_object) : T_map_object;
  const std::optional<Ray> mean =
      planar ? inPlane(T_map_object, line) : Ray{line.point, line.direction};
  if (!mean) return std::nullopt;
  ContactHypotheses result;
  result.id = hashOf(T_map_object, line);
  result.lever = {mean->foot.norm(), std::hypot(line.offset_stddev, line.pitch), T.translation()};
  UncertainLine lines(*mean, line, result.id, planar);
  // A spread that the tolerance covers needs no more places than an exact line.
  const bool exact = lines.spread(parameters.reach) < parameters.tolerance;
  const int count = exact ? kCandidates / 2 : kCandidates;
  const double spacing = 2.0 * parameters.reach / count;
  for (int i = 0; i < count; ++i) {
    const double along = (i + 0.5 - 0.5 * count) * spacing;
    const Ray ray = lines.next();
    addPlace(T, ray.foot + along * ray.direction, ray.direction, parameters, &result);
  }
  if (result.count == 0) return std::nullopt;
  normalise(&result.log_prior, result.count);
  return result;
}

}  // namespace smore
