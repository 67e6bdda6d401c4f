// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "smore/common/cell_key.h"

namespace smore {

/// One bit for each sampled explanation of the evidence.
using HypothesisMask = std::uint64_t;
constexpr int kHypotheses = 64;

/// Masks of the cells of an endless lattice. Memory goes to where they are not 0: cells lie in
/// bricks of eight a side (of one layer where the lattice is `flat`), which are found by an
/// open-addressing index. Coordinates of cells are below 2^23 in size.
class MaskBricks {
 public:
  using Cell = std::array<int, 3>;  ///< x, y and z
  static constexpr int kSide = 8;

  explicit MaskBricks(bool flat = false) : layer_bits_(flat ? 0 : kSideBits), slots_(1) {}

  HypothesisMask at(int x, int y, int z) const {
    const std::uint32_t brick = find(cellKey(x >> kSideBits, y >> kSideBits, z >> layer_bits_));
    return brick == kNone ? 0 : masks_[brick + offsetOf(x, y, z)];
  }

  /// A cell that will be looked up.
  struct Place {
    std::uint64_t key = 0;  ///< of its brick
    std::size_t offset = 0;
  };

  /// What `at` reads, in two steps each of which sends for the memory that the next one reads: many
  /// cells are waited for together. Valid until a cell is marked.
  Place placeOf(int x, int y, int z) const {
    const std::uint64_t key = cellKey(x >> kSideBits, y >> kSideBits, z >> layer_bits_);
    __builtin_prefetch(&slots_[slotOf(key)]);
    return {key, offsetOf(x, y, z)};
  }
  const HypothesisMask* maskAt(const Place& place) const {
    static constexpr HypothesisMask kNothing = 0;
    const std::uint32_t brick = find(place.key);
    if (brick == kNone) return &kNothing;
    const HypothesisMask* mask = &masks_[brick + place.offset];
    __builtin_prefetch(mask);
    return mask;
  }

  /// Adds to the mask of a cell.
  void mark(int x, int y, int z, HypothesisMask mask) {
    if (mask != 0) masks_[findOrAdd({x, y, z}) + offsetOf(x, y, z)] |= mask;
  }

  /// The bricks that `count` cells along x from `first` on lie in, one after the other; empty where
  /// there are none. Rows of other y and z lie in the same bricks as long as they are in that of
  /// `first`.
  using BricksOfRow = std::vector<std::uint32_t>;
  BricksOfRow bricksOfRow(const Cell& first, int count) const;

  /// Writes the masks of `count` cells along x from `first` on, which lie in `bricks`; false where
  /// all of them are 0.
  bool row(const Cell& first, int count, const BricksOfRow& bricks, HypothesisMask* masks) const;

  /// Adds the masks of kSide cells along x, the first of which begins a brick.
  void markRow(const Cell& first, const HypothesisMask* masks);

  /// Adds the masks of other such lattices.
  void add(const std::vector<MaskBricks>& others);
  void add(const MaskBricks& other);

  bool flat() const { return layer_bits_ == 0; }
  /// The lowest cell of each brick, in the order in which they were added.
  const std::vector<Cell>& bricks() const { return lowest_cells_; }
  /// Layers of a brick along z.
  int layers() const { return 1 << layer_bits_; }

 private:
  static constexpr int kSideBits = 3;
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t brick = kNone;  ///< where its masks begin
  };

  std::size_t offsetOf(int x, int y, int z) const {
    constexpr int kLast = kSide - 1;
    const int layer = z & ((1 << layer_bits_) - 1);
    return static_cast<std::size_t>((layer * kSide + (y & kLast)) * kSide + (x & kLast));
  }
  std::size_t slotOf(std::uint64_t key) const {  // Fibonacci hashing (Knuth, vol. 3, 6.4)
    return (key * 0x9E3779B97F4A7C15ULL >> 32) & (slots_.size() - 1);
  }
  std::uint32_t find(std::uint64_t key) const {
    std::size_t slot = slotOf(key);
    while (slots_[slot].brick != kNone && slots_[slot].key != key) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slots_[slot].brick;
  }
  std::size_t cellsInBrick() const { return std::size_t{kSide * kSide} << layer_bits_; }
  std::uint32_t findOrAdd(const Cell& cell);
  void insert(const Slot& entry);
  void grow();

  int layer_bits_;
  std::vector<Slot> slots_;  ///< a power of two of them, less than half in use
  std::vector<Cell> lowest_cells_;
  std::vector<HypothesisMask> masks_;  ///< brick after brick, x fastest
};

}  // namespace smore
