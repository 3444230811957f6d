#include "analyses/time_history/observers.hpp"

#include <exception>
#include <utility>

namespace moat {

void Observers::add(StepObserver& observer) { followers_.push_back({&observer, false}); }

void Observers::start(const StepView& view) {
  for (std::size_t i = 0; i < followers_.size(); ++i)
    if (!std::exchange(followers_[i].started, true)) followers_[i].observer->start(view);
}

void Observers::finish(const StepView& view) const {
  std::exception_ptr failure;
  for (std::size_t i = 0; i < followers_.size(); ++i) {
    try {
      followers_[i].observer->finish(view);
    } catch (...) {
      if (!failure) failure = std::current_exception();
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace moat
