#include "analyses/observers.hpp"

#include <algorithm>
#include <exception>

namespace moat {

void Observers::add(StepObserver& observer) { followers_.push_back({&observer, false}); }

bool Observers::need_results_of(std::size_t block) const {
  return std::ranges::any_of(followers_, [&](const Follower& each) { return each.observer->needs_results_of(block); });
}

void Observers::start(const StepView& view) {
  for (Follower& follower : followers_) {
    if (follower.started) continue;
    follower.started = true;
    follower.observer->start(view);
  }
}

void Observers::finish(const StepView& view) const {
  std::exception_ptr failure;
  for (const Follower& follower : followers_) {
    try {
      follower.observer->finish(view);
    } catch (...) {
      if (!failure) failure = std::current_exception();
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace moat
