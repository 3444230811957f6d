// Which names are taken.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace moat {

/// Remembers names by their hashes alone, in one table: the names of a million elements, kept a second time, would be
/// much of a model's memory. Two names may share a hash; after true the caller has to compare the names.
class TakenNames {
 public:
  void add(std::string_view name) {
    if (2 * (count_ + 1) > table_.size()) grow();
    insert(hash(name));
    ++count_;
  }
  /// False: surely not taken.
  [[nodiscard]] bool may_contain(std::string_view name) const {
    if (table_.empty()) return false;
    const std::uint64_t wanted = hash(name);
    for (std::size_t i = wanted & (table_.size() - 1);; i = (i + 1) & (table_.size() - 1)) {
      if (table_[i] == wanted) return true;
      if (table_[i] == nothing) return false;
    }
  }

 private:
  static constexpr std::uint64_t nothing = 0;

  static std::uint64_t hash(std::string_view name) {
    const std::uint64_t value = std::hash<std::string_view>{}(name);
    return value == nothing ? 1 : value;
  }
  void insert(std::uint64_t value) {
    std::size_t i = value & (table_.size() - 1);
    while (table_[i] != nothing) i = (i + 1) & (table_.size() - 1);
    table_[i] = value;
  }
  // The size stays a power of two, so that a mask picks the place.
  void grow() {
    const std::vector<std::uint64_t> old = std::move(table_);
    table_.assign(old.empty() ? 16 : 2 * old.size(), nothing);
    for (const std::uint64_t value : old)
      if (value != nothing) insert(value);
  }

  std::vector<std::uint64_t> table_;
  std::size_t count_ = 0;
};

}  // namespace moat
