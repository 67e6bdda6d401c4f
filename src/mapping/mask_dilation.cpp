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
      : marked_(marked), ball_(rowsOfBall(radius, marked.flat())) {
    for (const BallRow& row : ball_) {
      reach_ = std::max(reach_, row.half_length);
      height_ = std::max(height_, row.z);
    }
  }

  // All boxes that a ball around a marked cell may reach, of those that fill the lattice.
  std::vector<CellBox> boxes() const {
    const int layers = marked_.flat() ? 1 : kBoxLayers;
    std::set<Cell> lowest;
    const int side = MaskBricks::kSide - 1 + reach_;
    const int top = marked_.layers() - 1 + height_;
    for (const auto& [x, y, z] : marked_.bricks()) {
      const Cell first = boxAround({x - reach_, y - reach_, z - height_}, kBoxSide, layers).lowest;
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
    const auto& [first, side, layers] = box;
    const int width = side + 2 * reach_;
    Tile result{box,
                {first[0] - reach_, first[1] - reach_, first[2] - height_},
                {first[0] + side + reach_, first[1] + side + reach_, first[2] + layers + height_},
                std::vector<HypothesisMask>(static_cast<std::size_t>(side) * side * layers),
                std::vector<HypothesisMask>(width),
                std::vector<HypothesisMask>(width)};
    Cell brick = result.low;
    for (brick[2] = floorTo(brick[2], marked_.layers()); brick[2] < result.high[2];
         brick[2] += marked_.layers()) {
      for (brick[1] = floorTo(result.low[1], MaskBricks::kSide); brick[1] < result.high[1];
           brick[1] += MaskBricks::kSide) {
        addRowsAt(brick, &result);
      }
    }
    return inBricks(result);
  }

 private:
  struct Tile {
    CellBox box;
    Cell low;  // of the cells whose balls may reach it, and beyond the highest of them
    Cell high;
    std::vector<HypothesisMask> masks;
    std::vector<HypothesisMask> row;      // of marked cells
    std::vector<HypothesisMask> widened;  // that row
  };

  // All rows that lie in the same bricks as the one from `brick` on.
  void addRowsAt(const Cell& brick, Tile* tile) const {
    const auto width = static_cast<int>(tile->row.size());
    const MaskBricks::BricksOfRow bricks = marked_.bricksOfRow(brick, width);
    if (bricks.empty()) return;
    const int end_y = std::min(tile->high[1], brick[1] + MaskBricks::kSide);
    const int end_z = std::min(tile->high[2], brick[2] + marked_.layers());
    for (int z = std::max(tile->low[2], brick[2]); z < end_z; ++z) {
      for (int y = std::max(tile->low[1], brick[1]); y < end_y; ++y) {
        if (marked_.row({brick[0], y, z}, width, bricks, tile->row.data())) addBalls(y, z, tile);
      }
    }
  }

  // A ball is rows along x, each of its own half length: a row of marked cells is widened once for
  // each of these lengths.
  void addBalls(int row_y, int row_z, Tile* tile) const {
    int half_length = -1;
    for (const BallRow& of_ball : ball_) {
      for (; half_length < of_ball.half_length; ++half_length) {
        widen(tile->row, half_length + 1, &tile->widened);
      }
      const auto& [first, side, layers] = tile->box;
      const int y = row_y + of_ball.y - first[1];
      const int z = row_z + of_ball.z - first[2];
      if (y < 0 || y >= side || z < 0 || z >= layers) continue;
      unite(&tile->widened[reach_], side, &tile->masks[(z * side + y) * side]);
    }
  }

  MaskBricks inBricks(const Tile& tile) const {
    const auto& [first, side, layers] = tile.box;
    MaskBricks result(marked_.flat());
    const HypothesisMask* row = tile.masks.data();
    for (int z = 0; z < layers; ++z) {
      for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; x += MaskBricks::kSide, row += MaskBricks::kSide) {
          result.markRow({first[0] + x, first[1] + y, first[2] + z}, row);
        }
      }
    }
    return result;
  }

  const MaskBricks& marked_;
  std::vector<BallRow> ball_;
  int reach_ = 0;   ///< of the ball along x and y
  int height_ = 0;  ///< of the ball along z
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

MaskBricks dilated(const MaskBricks& marked, float radius, const CellBox& box) {
  return Dilation(marked, radius).dilatedIn(box);
}

}  // namespace smore
