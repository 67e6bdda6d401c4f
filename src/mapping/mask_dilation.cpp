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

// Cells of the whole that are made at a time: rows that are long against a ball, in half a
// megabyte.
constexpr int kBoxSide = 64;
constexpr int kBoxLayers = 16;

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

bool areZero(const HypothesisMask* row, int count) {
  HypothesisMask any = 0;
  for (int i = 0; i < count; ++i) any |= row[i];
  return any == 0;
}

int floorTo(int value, int step) { return value - ((value % step) + step) % step; }

// A ball around each marked cell, row by row.
class Ball {
 public:
  Ball(float radius, bool flat) : rows_(rowsOfBall(radius, flat)) {
    for (const BallRow& row : rows_) {
      reach_ = std::max(reach_, row.half_length);
      height_ = std::max(height_, row.z);
    }
  }

  int reach() const { return reach_; }    ///< along x and y
  int height() const { return height_; }  ///< along z

  // Adds to `result` the balls around a row of marked cells along x, at the y and z of its box,
  // from `reach` cells before the box to as many behind it. A ball is rows along x, each of its own
  // half length: the marked row is widened once for each of these lengths. `widened` is scratch, as
  // long as the row.
  void addAround(const HypothesisMask* row, int row_y, int row_z,
                 std::vector<HypothesisMask>* widened, MaskBox* result) const {
    const CellBox& box = result->box();
    int half_length = -1;
    for (const BallRow& of_ball : rows_) {
      for (; half_length < of_ball.half_length; ++half_length) {
        widen(row, half_length + 1, widened);
      }
      const int y = row_y + of_ball.y;
      const int z = row_z + of_ball.z;
      if (y < 0 || y >= box.side || z < 0 || z >= box.layers) continue;
      unite(&(*widened)[reach_], box.side, result->row(y, z));
    }
  }

 private:
  // Adds to `widened` what is in the cells `distance` away on both sides.
  static void widen(const HypothesisMask* row, int distance, std::vector<HypothesisMask>* widened) {
    const int width = static_cast<int>(widened->size());
    if (distance >= width) return;
    if (distance == 0) std::copy_n(row, width, widened->data());
    unite(row + distance, width - distance, widened->data());
    unite(row, width - distance, &(*widened)[distance]);
  }

  std::vector<BallRow> rows_;
  int reach_ = 0;
  int height_ = 0;
};

CellBox widenedBy(const Ball& ball, const CellBox& box) {
  const auto& [low, side, layers] = box;
  return {{low[0] - ball.reach(), low[1] - ball.reach(), low[2] - ball.height()},
          side + 2 * ball.reach(),
          layers + 2 * ball.height()};
}

// Of marked bricks.
class Dilation {
 public:
  Dilation(const MaskBricks& marked, float radius)
      : marked_(marked), ball_(radius, marked.flat()) {}

  // All boxes that a ball around a marked cell may reach, of those that fill the lattice.
  std::vector<CellBox> boxes() const {
    const int layers = marked_.flat() ? 1 : kBoxLayers;
    std::set<Cell> lowest;
    const int side = MaskBricks::kSide - 1 + ball_.reach();
    const int top = marked_.layers() - 1 + ball_.height();
    for (const auto& [x, y, z] : marked_.bricks()) {
      const Cell first =
          boxAround({x - ball_.reach(), y - ball_.reach(), z - ball_.height()}, kBoxSide, layers)
              .lowest;
      Cell at;
      for (at[2] = first[2]; at[2] <= z + top; at[2] += layers) {
        for (at[1] = first[1]; at[1] <= y + side; at[1] += kBoxSide) {
          for (at[0] = first[0]; at[0] <= x + side; at[0] += kBoxSide) lowest.insert(at);
        }
      }
    }
    std::vector<CellBox> boxes;
    boxes.reserve(lowest.size());
    for (const Cell& cell : lowest) boxes.push_back({cell, kBoxSide, layers});
    return boxes;
  }

  MaskBricks dilatedIn(const CellBox& box) const {
    Tile tile{MaskBox(box), widenedBy(ball_, box), {}, {}};
    tile.row.resize(tile.around.side);
    tile.widened.resize(tile.around.side);
    const Cell& low = tile.around.lowest;
    Cell brick = low;
    for (brick[2] = floorTo(low[2], marked_.layers()); brick[2] < low[2] + tile.around.layers;
         brick[2] += marked_.layers()) {
      for (brick[1] = floorTo(low[1], MaskBricks::kSide); brick[1] < low[1] + tile.around.side;
           brick[1] += MaskBricks::kSide) {
        addRowsAt(brick, &tile);
      }
    }
    return inBricks(tile.masks);
  }

 private:
  struct Tile {
    MaskBox masks;
    CellBox around;                       // the cells whose balls may reach it
    std::vector<HypothesisMask> row;      // of marked cells
    std::vector<HypothesisMask> widened;  // that row
  };

  // All rows that lie in the same bricks as the one from `brick` on.
  void addRowsAt(const Cell& brick, Tile* tile) const {
    const auto& [low, side, layers] = tile->around;
    const Cell& first = tile->masks.box().lowest;
    const MaskBricks::BricksOfRow bricks = marked_.bricksOfRow(brick, side);
    if (bricks.empty()) return;
    const int end_y = std::min(low[1] + side, brick[1] + MaskBricks::kSide);
    const int end_z = std::min(low[2] + layers, brick[2] + marked_.layers());
    for (int z = std::max(low[2], brick[2]); z < end_z; ++z) {
      for (int y = std::max(low[1], brick[1]); y < end_y; ++y) {
        if (!marked_.row({brick[0], y, z}, side, bricks, tile->row.data())) continue;
        ball_.addAround(tile->row.data(), y - first[1], z - first[2], &tile->widened, &tile->masks);
      }
    }
  }

  MaskBricks inBricks(const MaskBox& masks) const {
    const auto& [first, side, layers] = masks.box();
    MaskBricks result(marked_.flat());
    for (int z = 0; z < layers; ++z) {
      for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; x += MaskBricks::kSide) {
          result.markRow({first[0] + x, first[1] + y, first[2] + z}, masks.row(y, z) + x);
        }
      }
    }
    return result;
  }

  const MaskBricks& marked_;
  Ball ball_;
};

}  // namespace

CellBox boxAround(const Cell& cell, int side, int layers) {
  return {{floorTo(cell[0], side), floorTo(cell[1], side), floorTo(cell[2], layers)}, side, layers};
}

MaskBricks dilated(const MaskBricks& marked, float radius) {
  const Dilation dilation(marked, radius);
  const std::vector<CellBox> boxes = dilation.boxes();
  std::vector<MaskBricks> parts(boxes.size());
  parallelFor(boxes.size(), [&](std::size_t i) { parts[i] = dilation.dilatedIn(boxes[i]); });
  MaskBricks result(marked.flat());
  result.add(parts);
  return result;
}

CellBox widened(const CellBox& box, float radius, bool flat) {
  return widenedBy(Ball(radius, flat), box);
}

MaskBox dilated(const MaskBox& marked, float radius, bool flat, const CellBox& box) {
  const Ball ball(radius, flat);
  const auto& [low, side, layers] = marked.box();
  std::vector<HypothesisMask> scratch(side);
  MaskBox result(box);
  for (int z = 0; z < layers; ++z) {
    for (int y = 0; y < side; ++y) {
      const HypothesisMask* row = marked.row(y, z);
      if (areZero(row, side)) continue;
      ball.addAround(row, y - ball.reach(), z - ball.height(), &scratch, &result);
    }
  }
  return result;
}

}  // namespace smore
