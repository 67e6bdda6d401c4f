// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace smore {

/// Counts how often each bit was set in the sets added: the counts lie in binary across words, one
/// word of the first digits of 64 counts, one of their second digits and so on, so that one set is
/// added in a few operations, however many bits it has. Up to 2^20 - 1 sets.
template <std::size_t Words>
class BitCounts {
 public:
  void add(std::array<std::uint64_t, Words> carry) {
    ++sets_;
    if ((sets_ & (sets_ - 1)) == 0) ++used_;
    // No way out when nothing is carried any more: it would cost more than the operations.
    for (std::size_t digit = 0; digit < used_; ++digit) {
      for (std::size_t word = 0; word < Words; ++word) {
        const std::uint64_t digits = digits_[digit][word];
        digits_[digit][word] = digits ^ carry[word];
        carry[word] &= digits;
      }
    }
  }

  /// Of each bit.
  std::array<std::int32_t, 64 * Words> counts() const {
    std::array<std::int32_t, 64 * Words> result{};
    for (std::size_t digit = 0; digit < used_; ++digit) {
      for (std::size_t word = 0; word < Words; ++word) {
        const std::uint64_t digits = digits_[digit][word];
        if (digits == 0) continue;
        for (std::size_t bit = 0; bit < 64; ++bit) {
          result[64 * word + bit] |= static_cast<std::int32_t>((digits >> bit) & 1U) << digit;
        }
      }
    }
    return result;
  }

 private:
  static constexpr std::size_t kDigits = 20;
  std::array<std::array<std::uint64_t, Words>, kDigits> digits_{};
  std::size_t sets_ = 0;
  std::size_t used_ = 0;  ///< digits of sets_
};

}  // namespace smore
