// Names that are taken.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

namespace moat {

/// Remembers names by their hashes alone: the names of a million elements, kept a second time, would be a notable part
/// of a model's memory. Two names may share a hash; the caller then has to compare the names.
///
/// Hashes of names with the same first word stand together: those of one building, which are added one after the other.
/// In one table for all names nearly every new name would wait for memory.
class TakenNames {
 public:
  /// Remembers a name. False if it may have been taken already; a second time changes nothing.
  bool add(std::string_view name) {
    return words_.find_or_add(hash_of(first_word(name))).first.names.find_or_add(hash_of(name)).second;
  }
  /// False: surely not taken.
  [[nodiscard]] bool may_contain(std::string_view name) const {
    const Word* word = words_.find(hash_of(first_word(name)));
    return word != nullptr && word->names.find(hash_of(name)) != nullptr;
  }

 private:
  static constexpr std::size_t free = 0;  // no hash

  // Entries stand in one array of 2^n places, at least a fifth of which are free: each in the place that the last n
  // bits of its hash name, or in the next free one. std::unordered_map would ask for memory for every entry, and look
  // at three places of memory to find one.
  template <class Entry>
  class Table {
   public:
    // The entry, and whether it is new.
    std::pair<Entry&, bool> find_or_add(std::size_t hash) {
      if (5 * (count_ + 1) > 4 * places_.size()) grow();
      Entry& entry = places_[place_of(hash)];
      const bool is_new = entry.hash == free;
      entry.hash = hash;
      if (is_new) ++count_;
      return {entry, is_new};
    }
    // Null where there is none.
    [[nodiscard]] const Entry* find(std::size_t hash) const {
      if (places_.empty()) return nullptr;
      const Entry& entry = places_[place_of(hash)];
      return entry.hash == free ? nullptr : &entry;
    }

   private:
    // Where this hash stands, or a free place for it.
    [[nodiscard]] std::size_t place_of(std::size_t hash) const {
      const std::size_t last_bits = places_.size() - 1;
      std::size_t place = hash & last_bits;
      while (places_[place].hash != free && places_[place].hash != hash) place = (place + 1) & last_bits;
      return place;
    }
    void grow() {
      constexpr std::size_t first_size = 8;
      std::vector<Entry> before = std::exchange(places_, {});
      places_.resize(std::max(first_size, 2 * before.size()));
      for (Entry& entry : before)
        if (entry.hash != free) places_[place_of(entry.hash)] = std::move(entry);
    }

    std::vector<Entry> places_;
    std::size_t count_ = 0;
  };
  struct Name {
    std::size_t hash = free;
  };
  // The names that begin with it.
  struct Word {
    std::size_t hash = free;
    Table<Name> names;
  };

  [[nodiscard]] static std::size_t hash_of(std::string_view text) {
    return std::max(std::hash<std::string_view>{}(text), free + 1);
  }
  // Empty where the name is one word.
  [[nodiscard]] static std::string_view first_word(std::string_view name) {
    const std::size_t space = name.find(' ');
    return space == std::string_view::npos ? std::string_view{} : name.substr(0, space);
  }

  Table<Word> words_;
};

}  // namespace moat
