// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Before a function whose innermost loop is worth wider vectors where the processor has them. They
/// round alike, since multiplications and additions stay apart.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define SMORE_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define SMORE_WIDE_VECTORS
#endif
