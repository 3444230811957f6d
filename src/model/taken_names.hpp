// Names that are taken.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <unordered_set>

namespace moat {

/// Remembers names by their hashes alone: the names of a million elements, kept a second time, would be a seventh of a
/// model's memory. Two names may share a hash; after true the caller has to compare the names.
class TakenNames {
 public:
  void add(std::string_view name) { hashes_.insert(std::hash<std::string_view>{}(name)); }
  /// False: surely not taken.
  [[nodiscard]] bool may_contain(std::string_view name) const {
    return hashes_.contains(std::hash<std::string_view>{}(name));
  }

 private:
  std::unordered_set<std::size_t> hashes_;
};

}  // namespace moat
