// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <cstdint>

#include "smore/ros/names.h"

namespace smore {

/// A topic that sends each revision of something once, when somebody listens; what comes later
/// finds the last one latched.
class RevisedTopic {
 public:
  /// `on_listener`, if given, is called on the queue of `node` with each new listener: then what is
  /// due need not wait for the next look.
  template <typename Message>
  void open(ros::NodeHandle* node, const char* name,
            const ros::SubscriberStatusCallback& on_listener = {}) {
    constexpr bool kLatched = true;
    publisher_ = node->advertise<Message>(name, names::kLatestQueue, on_listener, {}, {}, kLatched);
  }

  /// Whether somebody listens who has not got this revision.
  bool isDue(std::uint64_t revision) const {
    return sent_ != revision + 1 && publisher_.getNumSubscribers() > 0;
  }

  /// What was sent counts no more.
  void renew() { sent_ = 0; }

  /// Sends what `make` makes, where it is due.
  template <typename Make>
  void send(std::uint64_t revision, Make make) {
    if (!isDue(revision)) return;
    publisher_.publish(make());
    sent_ = revision + 1;
  }

 private:
  ros::Publisher publisher_;
  std::uint64_t sent_ = 0;  ///< revision last sent plus one; 0: none
};

}  // namespace smore
