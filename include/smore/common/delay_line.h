// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <deque>
#include <optional>
#include <utility>

namespace smore {

/// Things on their way over a connection that may delay each by another time, but keeps their
/// order.
template <class Item>
class DelayLine {
 public:
  /// `arrival` [s, of the clock of `pop`]: not before it, nor before what was sent earlier.
  void push(double arrival, Item item) {
    if (!items_.empty()) arrival = std::max(arrival, items_.back().first);
    items_.emplace_back(arrival, std::move(item));
  }

  /// The next thing that has arrived by `now` [s]; nothing where none has.
  std::optional<Item> pop(double now) {
    if (items_.empty() || items_.front().first > now) return std::nullopt;
    Item item = std::move(items_.front().second);
    items_.pop_front();
    return item;
  }

 private:
  std::deque<std::pair<double, Item>> items_;
};

}  // namespace smore
