// Changes of regime inside steps, of the links of a block.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace moat {

/// The links that change their regime inside the step being tried, and those that did so inside the last two steps:
/// their forces need not be smooth yet. (StepControl does not judge the nodes of these elements.)
template <class State>
class LinkChanges {
 public:
  /// One change inside the step.
  struct Change {
    std::size_t link;  ///< index in the block
    State before;      ///< its history
    double fraction;   ///< of the step
    double heat;       ///< J, lost until then and then, which the account of the next regime does not see
  };

  /// Those of one link in the order in which they happen.
  void add(const Change& change) {
    of_step_.insert(std::ranges::upper_bound(of_step_, change.link, {}, &Change::link), change);
  }
  /// All, by link.
  [[nodiscard]] std::span<const Change> of_step() const { return of_step_; }
  /// Those of one link.
  [[nodiscard]] std::span<const Change> of(std::size_t link) const {
    const auto first = std::ranges::lower_bound(of_step_, link, {}, &Change::link);
    return {first, std::ranges::upper_bound(first, of_step_.end(), link, {}, &Change::link)};
  }
  /// The step is tried again.
  void clear() { of_step_.clear(); }
  /// The step was accepted.
  void commit() {
    before_last_.swap(last_);
    last_.clear();
    for (const Change& change : of_step_) last_.push_back(change.link);
    of_step_.clear();
  }
  /// The links that change or changed, ascending. Valid until the next call.
  [[nodiscard]] std::span<const std::size_t> links() {
    links_.assign(last_.begin(), last_.end());
    links_.insert(links_.end(), before_last_.begin(), before_last_.end());
    for (const Change& change : of_step_) links_.push_back(change.link);
    std::ranges::sort(links_);
    links_.erase(std::unique(links_.begin(), links_.end()), links_.end());
    return links_;
  }

 private:
  std::vector<Change> of_step_;  // by link
  std::vector<std::size_t> links_;
  std::vector<std::size_t> last_, before_last_;  // inside the last step, and inside the one before
};

}  // namespace moat
