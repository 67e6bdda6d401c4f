// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/forbidden_matter.h"

namespace smore {

ForbiddenMatter::ForbiddenMatter(const std::vector<MaskedPoint>& other,
                                 const std::vector<Eigen::Isometry3f>& poses,
                                 const Eigen::AlignedBox3f& region, float distance, float cell)
    : swept_(region, cell) {
  for (const Eigen::Isometry3f& T : poses) {
    for (const MaskedPoint& ball : other) swept_.mark(T * ball.point, ball.mask);
  }
  swept_.dilate(distance);
}

}  // namespace smore
