// What each entry of a vector or matrix receives from which elements.
#pragma once

#include <cstddef>
#include <vector>

#include "base/parallel.hpp"

namespace moat {

/// The scatter of a block of elements turned round: for every entry that elements add to, the elements and weights in
/// ascending order of elements. Threads can then share out entries and none writes where another does; and because
/// every entry receives its terms in the order in which a loop over the elements would add them, the sums are the same
/// to the last bit, whatever the number of threads.
class Shares {
 public:
  Shares() = default;

  /// for_each(element, add) calls add(entry, weight) for every entry the element adds to. Entries from `entries` on,
  /// those of the ground, are left out.
  template <class ForEach>
  Shares(std::size_t entries, std::size_t elements, const ForEach& for_each) {
    std::vector<std::size_t> next(entries + 1, 0);
    const auto within = [&](int entry) { return static_cast<std::size_t>(entry) < entries; };
    for (std::size_t e = 0; e < elements; ++e)
      for_each(e, [&](int entry, double) {
        if (within(entry)) ++next[static_cast<std::size_t>(entry) + 1];
      });
    for (std::size_t entry = 0; entry < entries; ++entry) {
      if (next[entry + 1] > 0) {
        entries_.push_back(entry);
        starts_.push_back(next[entry]);
      }
      next[entry + 1] += next[entry];
    }
    starts_.push_back(next[entries]);
    elements_.resize(next[entries]);
    weights_.resize(next[entries]);
    for (std::size_t e = 0; e < elements; ++e)
      for_each(e, [&](int entry, double weight) {
        if (!within(entry)) return;
        const std::size_t place = next[static_cast<std::size_t>(entry)]++;
        elements_[place] = e;
        weights_[place] = weight;
      });
  }

  /// sums[entry] += weight * value_of(element), for all entries.
  template <class ValueOf>
  void add(int threads, const ValueOf& value_of, double* sums) const {
    for_ranges(threads, entries_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        double sum = sums[entries_[i]];
        for (std::size_t k = starts_[i]; k < starts_[i + 1]; ++k) sum += weights_[k] * value_of(elements_[k]);
        sums[entries_[i]] = sum;
      }
    });
  }

 private:
  std::vector<std::size_t> entries_, starts_, elements_;
  std::vector<double> weights_;
};

}  // namespace moat
