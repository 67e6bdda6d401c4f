// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/surface_normals.h"

#include <array>
#include <cmath>

namespace smore {
namespace {

// Tilts beyond this number of standard deviations are outside of a cone of friction.
constexpr float kMostTilts = 1.5F;

// How much of the spread that friction gives to heights seen from one touch is allowed for in each
// pass: all while the plane is unknown, none once it is.
constexpr std::array<float, 4> kPasses = {1.0F, 0.0F, 0.0F, 0.0F};

float squared(float x) { return x * x; }

// Another touch as seen from one: how high above its tangent plane, and where along that.
struct Neighbour {
  float height;
  Eigen::Vector2f along;
  float alike;  // how likely it is that both forces stand on one plane, at most 1
};

struct Tangents {
  Eigen::Vector3f first;
  Eigen::Vector3f second;
};

std::vector<Neighbour> neighboursOf(std::size_t at, const std::vector<TouchedPoint>& touches,
                                    const Tangents& tangents, const SurfaceSpread& spread) {
  const Eigen::Vector3f& normal = touches[at].normal;
  std::vector<Neighbour> neighbours;
  for (std::size_t l = 0; l < touches.size(); ++l) {
    const Eigen::Vector3f way = touches[l].point - touches[at].point;
    if (l == at || way.norm() > spread.reach) continue;
    const float turned = (touches[l].normal - normal).norm() / (2.0F * spread.tilt);
    neighbours.push_back({way.dot(normal),
                          {way.dot(tangents.first), way.dot(tangents.second)},
                          1.0F / (1.0F + squared(turned))});
  }
  return neighbours;
}

// One step of the reweighted least squares: slopes of the plane along both tangents.
Eigen::Vector2f betterSlopes(const Eigen::Vector2f& slopes,
                             const std::vector<Neighbour>& neighbours, const SurfaceSpread& spread,
                             float allowed_tilt) {
  Eigen::Matrix2f precision = Eigen::Matrix2f::Identity() / squared(spread.tilt);
  Eigen::Vector2f sum = Eigen::Vector2f::Zero();
  for (const Neighbour& other : neighbours) {
    const float variance =
        squared(spread.height) + squared(allowed_tilt) * other.along.squaredNorm();
    const float off = other.height - other.along.dot(slopes);
    const float share = other.alike / (1.0F + squared(off) / variance);
    const float weight = squared(share / spread.height);
    precision += weight * other.along * other.along.transpose();
    sum += weight * other.height * other.along;
  }
  const Eigen::Vector2f better = precision.ldlt().solve(sum);
  const float most = kMostTilts * spread.tilt;
  return better.norm() > most ? Eigen::Vector2f(better * (most / better.norm())) : better;
}

}  // namespace

std::vector<Eigen::Vector3f> surfaceNormals(const std::vector<TouchedPoint>& touches,
                                            const SurfaceSpread& spread) {
  std::vector<Eigen::Vector3f> normals;
  normals.reserve(touches.size());
  for (std::size_t k = 0; k < touches.size(); ++k) {
    const Eigen::Vector3f& normal = touches[k].normal;
    const Eigen::Vector3f first = normal.unitOrthogonal();
    const Tangents tangents{first, normal.cross(first)};
    const std::vector<Neighbour> neighbours = neighboursOf(k, touches, tangents, spread);
    Eigen::Vector2f slopes = Eigen::Vector2f::Zero();
    for (const float share : kPasses) {
      slopes = betterSlopes(slopes, neighbours, spread, share * spread.tilt);
    }
    normals.push_back(
        (normal - slopes.x() * tangents.first - slopes.y() * tangents.second).normalized());
  }
  return normals;
}

}  // namespace smore
