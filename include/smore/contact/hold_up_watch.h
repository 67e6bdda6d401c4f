// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace smore {

/// Knows up to when a loop has heard the streams that are handed to it turn by turn. A turn that
/// takes long means that the loop was held up: it hears one stream after the other then, and knows
/// no more than before until it has listened as long as that in short turns. Held up while it
/// listens it waits no longer, so that of turns that are all long every second one knows what came.
///
/// All times are of one clock that never jumps [s].
class HoldUpWatch {
 public:
  /// A turn that takes longer than `longest_turn` [s], positive, is a hold-up.
  HoldUpWatch(double now, double longest_turn)
      : longest_turn_(longest_turn), begun_(now), listens_until_(now), heard_(now) {}

  /// A turn begins; what has come is handed over in it.
  void onTurn(double now) {
    const bool held_up = now - begun_ > longest_turn_;
    if (held_up && begun_ >= listens_until_) listens_until_ = now + longest_turn_;
    begun_ = now;
    if (begun_ >= listens_until_) heard_ = begun_;
  }

  /// What had come by then was handed over, at the end of the present turn.
  double heard() const { return heard_; }

  /// Whether that is all but what came in the present turn.
  bool upToDate(double now) const {
    return begun_ >= listens_until_ && now - begun_ <= longest_turn_;
  }

 private:
  double longest_turn_;
  double begun_;  ///< the present turn
  double listens_until_;
  double heard_;
};

}  // namespace smore
