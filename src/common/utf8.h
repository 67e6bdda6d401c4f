// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace smore {

/// Number of bytes from the beginning that are well-formed UTF-8 (Unicode 15, table 3-7: no
/// overlong forms, no surrogates, nothing beyond U+10FFFF). All of them for a valid text.
std::size_t validUtf8Prefix(const std::string& bytes);

/// Whether the bytes begin as UTF-16 does: with its byte order mark, or with an ASCII character and
/// a zero byte in either order.
bool isUtf16(const std::string& bytes);

}  // namespace smore
