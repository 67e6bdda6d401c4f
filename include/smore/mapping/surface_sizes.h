// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace smore {

/// How far touched matter goes on, in units of length: each world has one radius of all patches
/// around its touches, in planar motion one of those around the object's, and one depth of the
/// object behind its surface, log-uniform from the shortest to the longest.
struct ExtentParameters {
  double shortest = 0.2;        ///< as large as a patch that is just told from a point
  double object_longest = 6.0;  ///< on the object and behind its surface: what a gripper holds
  double world_longest = 6.0;   ///< in the world
};

/// One of kHypotheses sizes that are spread evenly over all orders of magnitude between the two.
double sizeOfHypothesis(int hypothesis, double shortest, double longest);

}  // namespace smore
