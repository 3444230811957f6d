#include "study/engine.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <functional>
#include <mutex>
#include <string_view>
#include <system_error>
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

/// Throws InputError for two results with one name, of which a table could hold only one, or the name of an axis.
void require_names_of_their_own(const StudyCase& each, const StudyRecord& record) {
  std::vector<std::pair<std::string_view, std::string_view>> names;
  for (const NamedNumber& result : record) names.emplace_back(result.quantity, result.where);
  std::ranges::sort(names);
  const auto twice = std::ranges::adjacent_find(names);
  if (twice != names.end()) {
    const std::string where = twice->second.empty() ? "" : " of \"" + std::string{twice->second} + "\"";
    throw InputError{"The result \"" + std::string{twice->first} + "\"" + where +
                     " appears twice. Give every result of a case a name or a place of its own."};
  }
  for (const StudyAxis& axis : each.cases().axes())
    if (std::ranges::binary_search(names, std::pair<std::string_view, std::string_view>{axis.name, ""}))
      throw InputError{"The result \"" + axis.name + "\" has the name of an axis. Give it another name."};
}

CaseOutcome caught(const StudyCase& each, const ComputeCase& compute) {
  try {
    CaseOutcome outcome = compute(each);
    require_names_of_their_own(each, outcome.results);
    return outcome;
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
  const FilesOfThisThread read;
  CaseOutcome outcome = caught(each, compute);
  for (const FileRead& file : read.files())
    if (std::ranges::find(outcome.files, file) == outcome.files.end()) outcome.files.push_back(file);
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

void compute_cases(const StudyCases& cases, const std::vector<std::size_t>& numbers,
                   const std::vector<ComputeCase>& workers, const CaseFinished& finished,
                   const std::function<bool()>& stop) {
  std::mutex mutex;  // of all that follows
  std::size_t next = 0;
  std::exception_ptr failure;
  const auto work = [&](const ComputeCase& compute) {
    std::unique_lock lock{mutex};
    while (!failure && next < numbers.size() && !(stop && stop())) {
      const std::size_t number = numbers[next++];
      lock.unlock();
      CaseOutcome outcome = compute(StudyCase{cases, number});
      lock.lock();
      if (failure) return;
      try {
        finished(number, std::move(outcome));
      } catch (...) {
        failure = std::current_exception();
      }
    }
  };
  {
    std::vector<std::jthread> others;
    try {
      for (std::size_t i = 1; i < std::min(workers.size(), numbers.size()); ++i)
        others.emplace_back(work, std::cref(workers[i]));
    } catch (const std::system_error&) {
      // The system gives no more threads: those that there are compute all cases.
    }
    work(workers.front());
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace moat
