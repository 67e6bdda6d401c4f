// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/forbidden_matter.h"

namespace smore {

ForbiddenMatter::ForbiddenMatter(const std::vector<MaskedPoint>& other,
                                 const std::vector<Eigen::Isometry3f>& poses,
                                 const Eigen::AlignedBox3f& region, float distance, float cell,
                                 bool planar)
    : swept_(cell, planar) {
  for (const Eigen::Isometry3f& T : poses) {
    for (const MaskedPoint& ball : other) {
      const Eigen::Vector3f center = T * ball.point;
      if (region.contains(center)) swept_.mark(center, ball.mask);
    }
  }
  swept_.dilate(distance);
}

Eigen::AlignedBox3f boxAround(const std::vector<MaskedPoint>& points, float margin) {
  Eigen::AlignedBox3f box;
  for (const MaskedPoint& point : points) box.extend(point.point);
  if (box.isEmpty()) return box;
  const Eigen::Vector3f margins = Eigen::Vector3f::Constant(margin);
  return {box.min() - margins, box.max() + margins};
}

}  // namespace smore
