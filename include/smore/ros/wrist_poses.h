// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/WrenchStamped.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <map>
#include <optional>
#include <string>

#include "smore/contact/contact_observation.h"
#include "smore/ros/conversions.h"

namespace smore {

/// Where the object and its wrist sensor were at the stamps of wrenches, from tf.
class WristPoses {
 public:
  explicit WristPoses(const FrameNames& frames) : frames_(frames) {}

  /// Takes the transforms of a message. What cannot be used (no frame, not newer than the last one
  /// of the same frame) is left out; what was wrong, else empty.
  std::string add(const tf2_msgs::TFMessage& message, bool is_static);

  /// Whether the object moves with this frame: it is the object's, or one between that and the root
  /// of tf.
  bool carriesObject(const std::string& frame) const;

  /// Forgets everything.
  void clear();

  /// The wrench in the object frame, with the pose at its stamp, rounded to 1e-9 m and rad: the
  /// same to the bit whatever transforms came since; a failure, with the reason, where tf does not
  /// know (yet).
  Result<WrenchSample> sampleOf(const geometry_msgs::WrenchStamped& message) const;

  /// Whether `stamp` is before the first pose of all, by less than `lead` [s].
  bool begunAfter(const ros::Time& stamp, double lead) const;

 private:
  Result<Pose> lookUp(const std::string& target, const std::string& source,
                      const ros::Time& stamp) const;

  FrameNames frames_;
  tf2::BufferCore transforms_;
  std::map<std::string, ros::Time> newest_;  ///< stamp of the newest transform of each frame
};

/// Why tf can never place something in this frame: a name that is empty or begins with '/'; empty
/// for any other.
std::string frameNameProblem(const std::string& frame);

}  // namespace smore
