// SPDX-License-Identifier: BSD-3-Clause
#include "smore/contact/sign_check.h"

#include <sstream>

#include "smore/contact/touch_work.h"

namespace smore {
namespace {

// The share of work that is clear; right touches of the tests' random scenes have at most 0.1 of
// the wrong sign. A turn of the line by its own error changes it by as much.
constexpr double kClearShare = 0.3;
constexpr double kSigmas = 3.0;

}  // namespace

std::string SignCheck::contradiction(const LineOfAction& line, const Pose& from, const Pose& to) {
  const double share = touchWorkShare(line, from, to);
  const double clear = kClearShare + kSigmas * line.direction_stddev;
  if (known_ || share < -clear) known_ = true;
  if (known_ || share < clear) return "";
  std::ostringstream problem;
  problem << "the first touch pulls where it should push: on the object's last way its force did "
          << share
          << " of the most work that it could, and what stands still does none; the wrench's sign "
             "is wrong (wrench_sign: -1), or its axes are (wrench_axes): push the object by hand "
             "along each axis to tell which";
  return problem.str();
}

}  // namespace smore
