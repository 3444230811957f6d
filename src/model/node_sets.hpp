// Sets of nodes that grow together.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace moat {

/// Every node is a set at first; sets are joined.
class NodeSets {
 public:
  /// Makes a set of each of the nodes 0 to count - 1.
  explicit NodeSets(int count) : parent_(static_cast<std::size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  /// The sets of two nodes become one; a node below zero, the ground, joins nothing.
  void join(int a, int b) {
    if (a < 0 || b < 0) return;
    a = first_of(a);
    b = first_of(b);
    at(std::max(a, b)) = std::min(a, b);
  }
  /// The first node of the set of a node.
  int first_of(int node) {
    while (at(node) != node) {
      // Halves the way to the first node for the next visit.
      at(node) = at(at(node));
      node = at(node);
    }
    return node;
  }
  /// The number of its set for every node, 0, 1, ... in the order of their first nodes.
  std::vector<int> numbers() {
    std::vector<int> number(parent_.size());
    int count = 0;
    for (int i = 0; i < static_cast<int>(parent_.size()); ++i) {
      const int first = first_of(i);
      number[static_cast<std::size_t>(i)] = first == i ? count++ : number[static_cast<std::size_t>(first)];
    }
    return number;
  }

 private:
  int& at(int node) { return parent_[static_cast<std::size_t>(node)]; }

  std::vector<int> parent_;
};

}  // namespace moat
