#include "study/ranks/rank_engine.hpp"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <exception>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "study/ranks/outcome_bytes.hpp"

namespace moat {
namespace {

// Rank 0 sends numbers of cases as text, then this.
constexpr const char* end_of_work = "end";
// A rank has its next case before it has ended the last one.
constexpr int cases_ahead = 2;

// MPI waits by polling at full load; the core belongs to the cases.
void pause_between_polls() { std::this_thread::sleep_for(std::chrono::microseconds{200}); }

std::size_t number_in(const std::string& text) {
  std::size_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

/// The cases that rank 0 computes itself, on threads of its own.
class OwnCases {
 public:
  OwnCases(const StudyCases& cases, const ComputeCase& compute, OpenCases& open, std::size_t threads)
      : running_{threads} {
    try {
      for (std::size_t i = 0; i < threads; ++i)
        threads_.emplace_back([this, &cases, &compute, &open] {
          std::size_t number = 0;
          while (open.next(number)) {
            CaseOutcome outcome = outcome_of(StudyCase{cases, number}, compute);
            const std::lock_guard lock{mutex_};
            ended_.emplace_back(number, std::move(outcome));
          }
          --running_;
        });
    } catch (const std::system_error&) {
      running_ -= threads - threads_.size();  // Fewer threads, and other ranks, compute all cases.
    }
  }

  std::vector<std::pair<std::size_t, CaseOutcome>> take_ended() {
    const std::lock_guard lock{mutex_};
    return std::exchange(ended_, {});
  }
  /// Asked before take_ended(): after true, no more cases end.
  [[nodiscard]] bool all_ended() const { return running_ == 0; }

 private:
  std::atomic<std::size_t> running_;
  std::mutex mutex_;
  std::vector<std::pair<std::size_t, CaseOutcome>> ended_;
  std::vector<std::jthread> threads_;  // last: they end before the members that they use
};

}  // namespace

void compute_as_first_rank(Ranks& ranks, const StudyCases& cases, const std::vector<std::size_t>& numbers,
                           const ComputeCase& compute, const CaseFinished& finished, const std::function<bool()>& stop,
                           std::size_t threads) {
  OpenCases open{numbers, stop};
  std::exception_ptr failure;
  const auto keep = [&](std::size_t number, CaseOutcome&& outcome) {
    if (failure) return;
    try {
      finished(number, std::move(outcome));
    } catch (...) {
      failure = std::current_exception();
      open.close();
    }
  };

  std::vector<int> in_flight(static_cast<std::size_t>(ranks.count()), 0);  // of every rank
  int working = ranks.count() - 1;
  const auto hand_out = [&](int to) {
    int& flying = in_flight[static_cast<std::size_t>(to)];
    for (std::size_t number = 0; flying < cases_ahead && open.next(number); ++flying)
      ranks.send(to, std::to_string(number));
    if (flying > 0) return;
    ranks.send(to, end_of_work);
    --working;
  };
  for (int rank = 1; rank < ranks.count(); ++rank) hand_out(rank);

  OwnCases own{cases, compute, open, threads};
  while (true) {
    const bool own_ended = own.all_ended();
    auto ended = own.take_ended();
    for (auto& [number, outcome] : ended) keep(number, std::move(outcome));
    const auto message = ranks.receive();
    if (message) {
      std::size_t number = 0;
      CaseOutcome outcome = from_bytes(message->bytes, number);
      --in_flight[static_cast<std::size_t>(message->from)];
      hand_out(message->from);
      keep(number, std::move(outcome));
    }
    if (own_ended && working == 0) break;
    if (!message && ended.empty()) pause_between_polls();
  }
  if (failure) std::rethrow_exception(failure);
}

void compute_as_other_rank(Ranks& ranks, const StudyCases& cases, const ComputeCase& compute) {
  while (true) {
    const auto message = ranks.receive();
    if (!message) {
      pause_between_polls();
      continue;
    }
    if (message->bytes == end_of_work) return;
    const std::size_t number = number_in(message->bytes);
    ranks.send(0, to_bytes(number, outcome_of(StudyCase{cases, number}, compute)));
  }
}

}  // namespace moat
