// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/mask_bricks.h"

#include <algorithm>

namespace smore {

std::uint32_t MaskBricks::findOrAdd(const Cell& cell) {
  const std::uint64_t key =
      cellKey(cell[0] >> kSideBits, cell[1] >> kSideBits, cell[2] >> layer_bits_);
  const std::uint32_t known = find(key);
  if (known != kNone) return known;
  if (2 * (lowest_cells_.size() + 1) >= slots_.size()) grow();
  const auto brick = static_cast<std::uint32_t>(masks_.size());
  insert({key, brick});
  masks_.resize(masks_.size() + cellsInBrick(), 0);
  lowest_cells_.push_back(
      {cell[0] & ~(kSide - 1), cell[1] & ~(kSide - 1), cell[2] & ~(layers() - 1)});
  return brick;
}

void MaskBricks::insert(const Slot& entry) {
  std::size_t slot = slotOf(entry.key);
  while (slots_[slot].brick != kNone) slot = (slot + 1) & (slots_.size() - 1);
  slots_[slot] = entry;
}

void MaskBricks::grow() {
  constexpr std::size_t kFirst = 64;
  std::vector<Slot> old(std::max(kFirst, 2 * slots_.size()));
  old.swap(slots_);
  for (const Slot& entry : old) {
    if (entry.brick != kNone) insert(entry);
  }
}

MaskBricks::BricksOfRow MaskBricks::bricksOfRow(const Cell& first, int count) const {
  const auto [begin, y, z] = first;
  BricksOfRow bricks;
  bool any = false;
  for (int x = begin >> kSideBits; x <= (begin + count - 1) >> kSideBits; ++x) {
    bricks.push_back(find(cellKey(x, y >> kSideBits, z >> layer_bits_)));
    any = any || bricks.back() != kNone;
  }
  return any ? bricks : BricksOfRow();
}

bool MaskBricks::row(const Cell& first, int count, const BricksOfRow& bricks,
                     HypothesisMask* masks) const {
  const auto [begin, y, z] = first;
  HypothesisMask any = 0;
  auto brick = bricks.begin();
  for (int i = 0; i < count; ++brick) {
    const int x = begin + i;
    const int length = std::min(count - i, kSide - (x & (kSide - 1)));
    if (*brick == kNone) {
      std::fill_n(masks + i, length, HypothesisMask{0});
    } else {
      const HypothesisMask* source = &masks_[*brick + offsetOf(x, y, z)];
      for (int k = 0; k < length; ++k) any |= masks[i + k] = source[k];
    }
    i += length;
  }
  return any != 0;
}

void MaskBricks::markRow(const Cell& first, const HypothesisMask* masks) {
  HypothesisMask any = 0;
  for (int k = 0; k < kSide; ++k) any |= masks[k];
  if (any == 0) return;
  HypothesisMask* row = &masks_[findOrAdd(first) + offsetOf(first[0], first[1], first[2])];
  for (int k = 0; k < kSide; ++k) row[k] |= masks[k];
}

// With memory for all of them at once: masks are many megabytes.
void MaskBricks::add(const std::vector<MaskBricks>& others) {
  std::size_t most = masks_.size();
  for (const MaskBricks& other : others) most += other.masks_.size();
  masks_.reserve(most);
  for (const MaskBricks& other : others) add(other);
}

void MaskBricks::add(const MaskBricks& other) {
  const HypothesisMask* source = other.masks_.data();
  for (const Cell& cell : other.lowest_cells_) {
    HypothesisMask* brick = &masks_[findOrAdd(cell)];
    for (std::size_t i = 0; i < cellsInBrick(); ++i) brick[i] |= *source++;
  }
}

}  // namespace smore
