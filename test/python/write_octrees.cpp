// SPDX-License-Identifier: BSD-3-Clause
// Writes trees by OctoMap itself, and beside each what it holds as text: a line "x y z size
// probability" for each leaf [m]. The test of the Python reader compares both.
#include <octomap/octomap.h>

#include <fstream>
#include <random>
#include <string>

namespace {

void write(const octomap::OcTree& tree, const std::string& name) {
  tree.write(name + ".ot");
  std::ofstream text(name + ".txt");
  text.precision(17);
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    text << leaf.getX() << " " << leaf.getY() << " " << leaf.getZ() << " " << leaf.getSize() << " "
         << leaf->getOccupancy() << "\n";
  }
}

// Scattered leaves on both sides of the origin.
octomap::OcTree scattered() {
  octomap::OcTree tree(0.03);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> position(-2.0F, 2.0F);
  std::uniform_real_distribution<float> log_odds(-1.9F, 3.4F);
  constexpr int kLeaves = 500;
  for (int i = 0; i < kLeaves; ++i) {
    const octomap::point3d point(position(random), position(random), position(random));
    tree.setNodeValue(point, log_odds(random));
  }
  return tree;
}

// Equal neighbours, which OctoMap prunes to coarse leaves, and one that differs.
octomap::OcTree pruned() {
  octomap::OcTree tree(0.05);
  constexpr int kFirst = 32760;
  constexpr int kLast = 32776;
  for (int x = kFirst; x < kLast; ++x) {
    for (int y = kFirst; y < kLast; ++y) {
      for (int z = kFirst; z < kLast; ++z) {
        const bool differs = x == kFirst && y == kFirst && z == kFirst;
        tree.setNodeValue(octomap::OcTreeKey(x, y, z), differs ? 1.5F : -0.5F);
      }
    }
  }
  tree.prune();
  return tree;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string folder = std::string(argv[1]) + "/";
  write(scattered(), folder + "scattered");
  write(pruned(), folder + "pruned");
  write(octomap::OcTree(0.1), folder + "empty");
  return 0;
}
