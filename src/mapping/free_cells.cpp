// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/free_cells.h"

#include <cmath>

#include "smore/mapping/counter_random.h"

namespace smore {

std::size_t FreeCells::HashOfCell::operator()(const Cell& cell) const {
  std::uint64_t hash = 0;
  for (const std::int32_t index : cell) hash = mixBits(hash, static_cast<std::uint32_t>(index));
  return hash;
}

FreeCells::Cell FreeCells::cellOf(const Pose& T_map_object) const {
  const Eigen::AngleAxisd turn(T_map_object.linear());
  const Vec3 rotation = turn.angle() * turn.axis();
  Cell cell{};
  for (int axis = 0; axis < 3; ++axis) {
    const double position = T_map_object.translation()[axis] / parameters_.position_cell;
    cell[axis] = static_cast<std::int32_t>(std::lround(position));
    cell[3 + axis] =
        static_cast<std::int32_t>(std::lround(rotation[axis] / parameters_.angle_cell));
  }
  return cell;
}

Pose FreeCells::centerOf(const Pose& T_map_object) const {
  const Cell cell = cellOf(T_map_object);
  Pose center = Pose::Identity();
  center.translation() = parameters_.position_cell * Vec3(cell[0], cell[1], cell[2]);
  const Vec3 rotation = parameters_.angle_cell * Vec3(cell[3], cell[4], cell[5]);
  const double angle = rotation.norm();
  if (angle > 0.0) center.linear() = Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
  return center;
}

}  // namespace smore
