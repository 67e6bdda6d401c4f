// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/mask_dilation.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "smore/common/parallel_for.h"
#include "smore/common/wide_vectors.h"

namespace smore {
namespace {

constexpr float kRounding = 1e-3F;  // of squared distances in cells

// Cells of the result that are made at a time: rows that are long against a ball, in half a
// megabyte.
constexpr int kTileSide = 64;
constexpr int kTileLayers = 16;

using Cell = MaskBricks::Cell;

// Cells along x of a ball around a cell, from -half_length to half_length.
struct BallRow {
  int y;
  int z;
  int half_length;
};

// The shortest rows first.
std::vector<BallRow> rowsOfBall(float radius, bool flat) {
  const int reach = static_cast<int>(std::ceil(radius)) - 1;
  const int height = flat ? 0 : reach;
  std::vector<BallRow> rows;
  for (int z = -height; z <= height; ++z) {
    for (int y = -reach; y <= reach; ++y) {
      const float left = radius * radius - static_cast<float>(z * z + y * y);
      if (left > kRounding) rows.push_back({y, z, static_cast<int>(std::sqrt(left - kRounding))});
    }
  }
  std::stable_sort(rows.begin(), rows.end(), [](const BallRow& a, const BallRow& b) {
    return a.half_length < b.half_length;
  });
  return rows;
}

SMORE_WIDE_VECTORS void unite(const HypothesisMask* source, int count,
                              HypothesisMask* destination) {
  for (int i = 0; i < count; ++i) destination[i] |= source[i];
}

// Adds to `widened` what is in the cells `distance` away on both sides.
void widen(const std::vector<HypothesisMask>& row, int distance,
           std::vector<HypothesisMask>* widened) {
  const int width = static_cast<int>(row.size());
  if (distance >= width) return;
  if (distance == 0) *widened = row;
  unite(&row[distance], width - distance, widened->data());
  unite(row.data(), width - distance, &(*widened)[distance]);
}

int floorTo(int value, int step) { return value - ((value % step) + step) % step; }

class Dilation {
 public:
  Dilation(const MaskBricks& marked, float radius)
      : marked_(marked),
        ball_(rowsOfBall(radius, marked.flat())),
        layers_(marked.flat() ? 1 : kTileLayers) {
    for (const BallRow& row : ball_) {
      reach_ = std::max(reach_, row.half_length);
      height_ = std::max(height_, row.z);
    }
  }

  // The lowest cells of all tiles that a ball around a marked cell may reach.
  std::vector<Cell> tiles() const {
    std::set<Cell> tiles;
    const int side = MaskBricks::kSide - 1 + reach_;
    const int top = marked_.layers() - 1 + height_;
    for (const Cell& brick : marked_.bricks()) {
      Cell tile;
      for (tile[2] = floorTo(brick[2] - height_, layers_); tile[2] <= brick[2] + top;
           tile[2] += layers_) {
        for (tile[1] = floorTo(brick[1] - reach_, kTileSide); tile[1] <= brick[1] + side;
             tile[1] += kTileSide) {
          for (tile[0] = floorTo(brick[0] - reach_, kTileSide); tile[0] <= brick[0] + side;
               tile[0] += kTileSide) {
            tiles.insert(tile);
          }
        }
      }
    }
    return {tiles.begin(), tiles.end()};
  }

  // A ball is rows along x, each of its own half length: a row of marked cells is widened once for
  // each of these lengths.
  MaskBricks dilatedIn(const Cell& tile) const {
    std::vector<HypothesisMask> masks(static_cast<std::size_t>(kTileSide) * kTileSide * layers_);
    std::vector<HypothesisMask> row(kTileSide + 2 * reach_);
    std::vector<HypothesisMask> widened(row.size());
    Cell first{tile[0] - reach_, 0, 0};
    for (first[2] = tile[2] - height_; first[2] < tile[2] + layers_ + height_; ++first[2]) {
      for (first[1] = tile[1] - reach_; first[1] < tile[1] + kTileSide + reach_; ++first[1]) {
        if (!marked_.row(first, static_cast<int>(row.size()), row.data())) continue;
        int half_length = -1;
        for (const BallRow& of_ball : ball_) {
          for (; half_length < of_ball.half_length; ++half_length) {
            widen(row, half_length + 1, &widened);
          }
          const int y = first[1] + of_ball.y - tile[1];
          const int z = first[2] + of_ball.z - tile[2];
          if (y < 0 || y >= kTileSide || z < 0 || z >= layers_) continue;
          unite(&widened[reach_], kTileSide, &masks[(z * kTileSide + y) * kTileSide]);
        }
      }
    }
    return inBricks(tile, masks);
  }

 private:
  MaskBricks inBricks(const Cell& tile, const std::vector<HypothesisMask>& masks) const {
    MaskBricks result(marked_.flat());
    const HypothesisMask* row = masks.data();
    for (int z = 0; z < layers_; ++z) {
      for (int y = 0; y < kTileSide; ++y) {
        for (int x = 0; x < kTileSide; x += MaskBricks::kSide, row += MaskBricks::kSide) {
          result.markRow({tile[0] + x, tile[1] + y, tile[2] + z}, row);
        }
      }
    }
    return result;
  }

  const MaskBricks& marked_;
  std::vector<BallRow> ball_;
  int layers_;
  int reach_ = 0;   ///< of the ball along x and y
  int height_ = 0;  ///< of the ball along z
};

}  // namespace

MaskBricks dilated(const MaskBricks& marked, float radius) {
  const Dilation dilation(marked, radius);
  const std::vector<Cell> tiles = dilation.tiles();
  std::vector<MaskBricks> parts(tiles.size());
  parallelFor(tiles.size(), [&](std::size_t i) { parts[i] = dilation.dilatedIn(tiles[i]); });
  MaskBricks result(marked.flat());
  for (const MaskBricks& part : parts) result.add(part);
  return result;
}

}  // namespace smore
