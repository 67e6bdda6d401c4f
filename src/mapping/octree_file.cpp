// SPDX-License-Identifier: BSD-3-Clause
#include "smore/mapping/octree_file.h"

#include <octomap/octomap.h>

#include <array>
#include <bitset>
#include <fstream>
#include <vector>

#include "smore/common/result.h"

namespace smore {
namespace {

constexpr std::size_t kLevels = 17;  // of nodes in a tree of depth 16, the root's among them

/// What the header of a file says.
struct Header {
  bool binary = false;
  std::string id;
  std::size_t nodes = 0;
};

// Leaves the stream where the nodes begin.
Header readHeader(std::istream* stream) {
  Header header;
  std::string word;
  std::getline(*stream, word);
  header.binary = word.find("binary") != std::string::npos;
  while (*stream >> word && word != "data") {
    if (word == "id") *stream >> header.id;
    if (word == "size") *stream >> header.nodes;
  }
  stream->get();  // the end of the line
  return header;
}

// How many nodes there are in a row, before the stream ends or they are no tree: OctoMap itself
// goes on beyond either. A node is its value, a bit for each child, and these.
std::size_t countNodes(std::istream* stream) {
  std::array<char, sizeof(float) + 1> node{};
  std::vector<std::size_t> missing = {1};  // nodes on each level, down to the present one
  std::size_t count = 0;
  while (!missing.empty() && stream->read(node.data(), node.size())) {
    ++count;
    --missing.back();
    const std::size_t children = std::bitset<8>(static_cast<unsigned char>(node.back())).count();
    if (children > 0) missing.push_back(children);
    if (missing.size() > kLevels) return 0;
    while (!missing.empty() && missing.back() == 0) missing.pop_back();
  }
  return missing.empty() ? count : 0;
}

[[noreturn]] void refuseKind(const std::string& file) {
  throw InputError(file + ": not an OctoMap of occupancies, or an empty one; write it with " +
                   "octomap_saver or octovis");
}

void requireNodes(const std::string& file, std::size_t found, std::size_t named) {
  if (found == named) return;
  throw InputError(file + ": holds " + std::to_string(found) + " of the " + std::to_string(named) +
                   " nodes that it names; the file was cut or damaged");
}

}  // namespace

std::unique_ptr<octomap::OcTree> readOctree(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  const Header header = readHeader(&stream);
  if (!stream || header.id != "OcTree" || header.nodes == 0) refuseKind(file);
  if (header.binary) {
    auto tree = std::make_unique<octomap::OcTree>(0.1);
    if (!tree->readBinary(file)) refuseKind(file);
    requireNodes(file, tree->size(), header.nodes);
    return tree;
  }
  requireNodes(file, countNodes(&stream), header.nodes);
  std::unique_ptr<octomap::AbstractOcTree> any(octomap::AbstractOcTree::read(file));
  if (dynamic_cast<octomap::OcTree*>(any.get()) == nullptr) refuseKind(file);
  return std::unique_ptr<octomap::OcTree>(dynamic_cast<octomap::OcTree*>(any.release()));
}

}  // namespace smore
