#include "study/engine.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

#include "base/error.hpp"

namespace moat {
namespace {

CaseOutcome with_reason(CaseState state, const char* reason) {
  CaseOutcome outcome;
  outcome.state = state;
  outcome.reason = reason;
  return outcome;
}

CaseOutcome caught(const StudyCase& each, const ComputeCase& compute) {
  try {
    return compute(each);
  } catch (const ConvergenceError& error) {
    return with_reason(CaseState::not_converged, error.what());
  } catch (const std::exception& error) {
    return with_reason(CaseState::failed, error.what());
  } catch (...) {
    return with_reason(CaseState::failed, "an exception that is not a std::exception");
  }
}

}  // namespace

CaseOutcome outcome_of(const StudyCase& each, const ComputeCase& compute) {
  const auto start = std::chrono::steady_clock::now();
  CaseOutcome outcome = caught(each, compute);
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

void compute_on_threads(const StudyCases& cases, const std::vector<std::size_t>& numbers, const ComputeCase& compute,
                        const CaseFinished& finished, const std::function<bool()>& stop, std::size_t threads) {
  OpenCases open{numbers, stop};
  std::mutex taking, telling;
  std::exception_ptr failure;
  const auto take = [&](std::size_t& number) {
    const std::lock_guard lock{taking};
    return open.next(number);
  };
  const auto work = [&] {
    std::size_t number = 0;
    while (take(number)) {
      CaseOutcome outcome = outcome_of(StudyCase{cases, number}, compute);
      const std::lock_guard lock{telling};
      if (failure) return;
      try {
        finished(number, std::move(outcome));
      } catch (...) {
        failure = std::current_exception();
        const std::lock_guard no_more{taking};
        open.close();
      }
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < std::min(threads, numbers.size()); ++i) others.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace moat
