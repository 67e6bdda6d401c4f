// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ompl/datastructures/NearestNeighbors.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace smore {

/// Exact nearest neighbours in any metric, for OMPL's planners: vantage-point trees (Yianilos, SODA
/// 1993) of doubling sizes, merged as elements come in (Bentley and Saxe, 1980).
///
/// OMPL's own tree draws its pivots from a random generator that cannot be seeded per planner, so
/// that runs would differ where distances tie. Here everything follows from the order of insertion.
template <typename T>
class NearestForest : public ompl::NearestNeighbors<T> {
 public:
  bool reportsSortedResults() const override { return true; }

  void clear() override {
    trees_.clear();
    size_ = 0;
  }

  void add(const T& data) override {
    std::vector<Node> merged = {{data, 0.0}};
    while (!trees_.empty() && trees_.back().size() <= merged.size()) {
      merged.insert(merged.end(), trees_.back().begin(), trees_.back().end());
      trees_.pop_back();
    }
    // Trees up to this size are scanned: ordering them costs more than it saves.
    if (merged.size() > kScanned) build(&merged, 0, merged.size());
    trees_.push_back(std::move(merged));
    ++size_;
  }

  bool remove(const T& data) override {
    std::vector<T> all;
    list(all);
    const auto found = std::find(all.begin(), all.end(), data);
    if (found == all.end()) return false;
    all.erase(found);
    clear();
    for (const T& element : all) add(element);
    return true;
  }

  T nearest(const T& data) const override {
    Best best{data, nullptr, std::numeric_limits<double>::infinity()};
    for (const auto& tree : trees_) search(tree, 0, tree.size(), &best);
    return best.node == nullptr ? T() : best.node->data;
  }

  void nearestK(const T& data, std::size_t k, std::vector<T>& neighbors) const override {
    list(neighbors);
    std::stable_sort(neighbors.begin(), neighbors.end(), [&](const T& a, const T& b) {
      return this->distFun_(a, data) < this->distFun_(b, data);
    });
    if (neighbors.size() > k) neighbors.resize(k);
  }

  void nearestR(const T& data, double radius, std::vector<T>& neighbors) const override {
    nearestK(data, size_, neighbors);
    const auto outside = std::find_if(neighbors.begin(), neighbors.end(),
                                      [&](const T& a) { return this->distFun_(a, data) > radius; });
    neighbors.erase(outside, neighbors.end());
  }

  std::size_t size() const override { return size_; }

  void list(std::vector<T>& data) const override {
    data.clear();
    for (const auto& tree : trees_) {
      for (const Node& node : tree) data.push_back(node.data);
    }
  }

 private:
  static constexpr std::size_t kScanned = 16;

  /// A tree is an array: the vantage point first, then those within its radius, then the others,
  /// the halves ordered likewise.
  struct Node {
    T data;
    double radius;
  };

  struct Best {
    const T& query;
    const Node* node;
    double distance;
  };

  static std::size_t middleOf(std::size_t begin, std::size_t end) {
    return begin + 1 + (end - begin - 1) / 2;
  }

  void build(std::vector<Node>* tree, std::size_t begin, std::size_t end) const {
    if (end - begin <= kScanned) return;
    const T vantage = (*tree)[begin].data;
    for (std::size_t i = begin + 1; i < end; ++i) {
      (*tree)[i].radius = this->distFun_(vantage, (*tree)[i].data);
    }
    const std::size_t middle = middleOf(begin, end);
    std::nth_element(tree->begin() + begin + 1, tree->begin() + middle, tree->begin() + end,
                     [](const Node& a, const Node& b) { return a.radius < b.radius; });
    (*tree)[begin].radius = (*tree)[middle].radius;
    build(tree, begin + 1, middle);
    build(tree, middle, end);
  }

  void consider(const Node& node, double distance, Best* best) const {
    if (distance < best->distance) {
      best->distance = distance;
      best->node = &node;
    }
  }

  void search(const std::vector<Node>& tree, std::size_t begin, std::size_t end, Best* best) const {
    if (end - begin <= kScanned) {
      for (std::size_t i = begin; i < end; ++i) {
        consider(tree[i], this->distFun_(best->query, tree[i].data), best);
      }
      return;
    }
    const Node& vantage = tree[begin];
    const double distance = this->distFun_(best->query, vantage.data);
    consider(vantage, distance, best);
    const std::size_t middle = middleOf(begin, end);
    const bool inside_first = distance < vantage.radius;
    if (inside_first) search(tree, begin + 1, middle, best);
    if (distance + best->distance >= vantage.radius) search(tree, middle, end, best);
    if (!inside_first && distance - best->distance <= vantage.radius) {
      search(tree, begin + 1, middle, best);
    }
  }

  std::vector<std::vector<Node>> trees_;  ///< sizes fall
  std::size_t size_ = 0;
};

}  // namespace smore
