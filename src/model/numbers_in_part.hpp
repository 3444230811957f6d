// Numbers of nodes in a part of a model.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "model/element_block.hpp"
#include "model/member_point.hpp"
#include "model/node.hpp"

namespace moat {

/// The numbers that the nodes of a part of a model have in that part, from those in the whole model.
class NumbersInPart {
 public:
  /// One number for every node of the whole model; those outside the part are never asked for.
  explicit NumbersInPart(std::vector<int> numbers) : numbers_{std::move(numbers)} {}

  /// The index in the part of a node, or of the ground.
  [[nodiscard]] int of(int index) const {
    return index == ground_index ? ground_index : numbers_[static_cast<std::size_t>(index)];
  }
  /// The same node in the part.
  [[nodiscard]] NodeId of(NodeId node) const { return NodeId{of(node.index)}; }
  /// The same point in the part.
  [[nodiscard]] MemberPoint of(MemberPoint point) const {
    point.node = of(point.node);
    point.other = of(point.other);
    return point;
  }
  /// The same element in the part.
  [[nodiscard]] ElementInfo of(ElementInfo info) const {
    info.first = of(info.first);
    info.second = of(info.second);
    if (const MemberEnds* ends = info.member_ends()) {
      ElementDetails details = *info.details;
      details.member_ends = MemberEnds{of(ends->first), of(ends->second), ends->height};
      info.details = std::make_shared<const ElementDetails>(std::move(details));
    }
    return info;
  }

 private:
  std::vector<int> numbers_;
};

/// The entries of `values` at these positions, in their order; nothing of an array without entries.
template <class List>
[[nodiscard]] List chosen(const List& values, std::span<const std::size_t> positions) {
  if (values.empty()) return {};
  List entries;
  for (const std::size_t i : positions) entries.push_back(values[i]);
  return entries;
}

/// The arrays of the part get the entries of those of the whole at these positions.
template <class Block, class... Arrays>
void take_chosen(Block& part, const Block& whole, std::span<const std::size_t> positions, Arrays Block::*... arrays) {
  ((part.*arrays = chosen(whole.*arrays, positions)), ...);
}

}  // namespace moat
