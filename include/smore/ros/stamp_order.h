// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <optional>

namespace smore {

/// Whether the messages of a stream come in the order of their stamps. One whose stamp lies more
/// than a second from the last one's, before or after, is believed once the next one goes on from
/// there: a single wrong stamp does not set the time of the stream.
class StampOrder {
 public:
  enum class Verdict {
    kNew,       ///< to be taken
    kRepeated,  ///< not newer than the last one
    kDoubtful,  ///< far from the last one, and not confirmed yet
    kWentBack,  ///< to be taken: time went back, as where a recording begins again
  };

  /// Of the next message. Any stamp is allowed.
  Verdict add(const ros::Time& stamp);

  /// Of the newest message that was taken; zero before the first.
  const ros::Time& newest() const { return newest_; }

  /// Forgets everything.
  void clear() { *this = StampOrder(); }

 private:
  bool isConfirmed(const ros::Time& stamp) const;

  ros::Time newest_;
  bool begun_ = false;
  std::optional<ros::Time> doubtful_;
};

}  // namespace smore
