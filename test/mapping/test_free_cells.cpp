// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "at_a_decimetre.h"
#include "smore/mapping/free_cells.h"

namespace smore {
namespace {

Pose randomPose(std::mt19937* engine) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto number = [&] { return uniform(*engine); };
  return makePose({number(), number(), number()}, {3.0 * number(), number(), 3.0 * number()});
}

TEST(FreeCells, KnowThePosesOfTheirCellsByTheirCentres) {
  const FreeSpaceParameters parameters = atADecimetre().free_space;
  std::mt19937 engine(2);
  for (int i = 0; i < 500; ++i) {
    FreeCells cells(parameters);
    const Pose pose = randomPose(&engine);
    const Pose center = cells.centerOf(pose);
    EXPECT_LE((center.translation() - pose.translation()).cwiseAbs().maxCoeff(),
              0.5 * parameters.position_cell + 1e-12);
    // Rotation vectors are at least as far apart as the rotations.
    EXPECT_LE(angleBetween(center, pose), 0.5 * std::sqrt(3.0) * parameters.angle_cell + 1e-7);
    EXPECT_FALSE(cells.knows(center));
    EXPECT_TRUE(cells.add(pose));
    EXPECT_FALSE(cells.add(center));
    EXPECT_TRUE(cells.knows(pose));
    EXPECT_EQ(cells.count(), 1U);
  }
}

TEST(FreeCells, TellApartWhatIsACellApart) {
  const FreeSpaceParameters parameters = atADecimetre().free_space;
  FreeCells cells(parameters);
  cells.add(Pose::Identity());
  EXPECT_TRUE(cells.add(makePose({parameters.position_cell, 0, 0})));
  EXPECT_TRUE(cells.add(makePose({0, 0, -parameters.position_cell})));
  EXPECT_TRUE(cells.add(makePose({0, 0, 0}, {0, parameters.angle_cell, 0})));
  EXPECT_EQ(cells.count(), 4U);
}

}  // namespace
}  // namespace smore
