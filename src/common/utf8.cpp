// SPDX-License-Identifier: BSD-3-Clause
#include "utf8.h"

#include <cstdint>

namespace smore {
namespace {

using Byte = std::uint8_t;

// Bytes that follow the first one; -1 where none may be first.
int followers(Byte first) {
  if (first < 0x80) return 0;
  if (first >= 0xC2 && first <= 0xDF) return 1;
  if (first >= 0xE0 && first <= 0xEF) return 2;
  if (first >= 0xF0 && first <= 0xF4) return 3;
  return -1;
}

// The second byte is bounded more narrowly after some first ones.
bool isSecond(Byte first, Byte second) {
  const Byte low = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const Byte high = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  return second >= low && second <= high;
}

bool isCharacterAt(const std::string& bytes, std::size_t at, int following) {
  if (following < 0 || at + static_cast<std::size_t>(following) >= bytes.size()) return false;
  const auto first = static_cast<Byte>(bytes[at]);
  for (int i = 1; i <= following; ++i) {
    const auto byte = static_cast<Byte>(bytes[at + static_cast<std::size_t>(i)]);
    if (i == 1 ? !isSecond(first, byte) : (byte & 0xC0U) != 0x80U) return false;
  }
  return true;
}

}  // namespace

std::size_t validUtf8Prefix(const std::string& bytes) {
  std::size_t at = 0;
  while (at < bytes.size()) {
    const int following = followers(static_cast<Byte>(bytes[at]));
    if (!isCharacterAt(bytes, at, following)) break;
    at += static_cast<std::size_t>(following) + 1;
  }
  return at;
}

bool isUtf16(const std::string& bytes) {
  if (bytes.size() < 2) return false;
  const auto first = static_cast<Byte>(bytes[0]);
  const auto second = static_cast<Byte>(bytes[1]);
  return (first == 0xFF && second == 0xFE) || (first == 0xFE && second == 0xFF) ||
         (first == 0) != (second == 0);
}

}  // namespace smore
