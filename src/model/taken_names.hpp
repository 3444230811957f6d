// Names that are taken.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

namespace moat {

/// Remembers names by their hashes alone: the names of a million elements, kept a second time, would be a seventh of a
/// model's memory. Two names may share a hash; the caller then has to compare the names.
///
/// The hashes stand in one array of 2^n places, at least a fifth of which are free: each in the place that its last n
/// bits name, or in the next free one. std::unordered_set would ask for memory for every hash.
class TakenNames {
 public:
  /// Remembers a name. False if it may have been taken already; a second time changes nothing.
  bool add(std::string_view name) {
    if (5 * (count_ + 1) > 4 * places_.size()) grow();
    const std::size_t hash = hash_of(name);
    std::size_t& place = places_[place_of(hash)];
    if (place != free) return false;
    place = hash;
    ++count_;
    return true;
  }
  /// False: surely not taken.
  [[nodiscard]] bool may_contain(std::string_view name) const {
    return count_ > 0 && places_[place_of(hash_of(name))] != free;
  }

 private:
  static constexpr std::size_t free = 0;

  [[nodiscard]] static std::size_t hash_of(std::string_view name) {
    return std::max(std::hash<std::string_view>{}(name), free + 1);
  }
  // Where this hash stands, or a free place for it.
  [[nodiscard]] std::size_t place_of(std::size_t hash) const {
    const std::size_t last_bits = places_.size() - 1;
    std::size_t place = hash & last_bits;
    while (places_[place] != free && places_[place] != hash) place = (place + 1) & last_bits;
    return place;
  }
  void grow() {
    constexpr std::size_t first_size = 16;
    const std::vector<std::size_t> before = std::exchange(places_, {});
    places_.assign(std::max(first_size, 2 * before.size()), free);
    for (const std::size_t hash : before)
      if (hash != free) places_[place_of(hash)] = hash;
  }

  std::vector<std::size_t> places_;
  std::size_t count_ = 0;
};

}  // namespace moat
