// Loops over ranges of elements, on one thread or several.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>

namespace moat {

/// What any thread may raise while a loop runs.
class Flag {
 public:
  Flag() = default;
  Flag(const Flag& other) : raised_{other.raised_.load()} {}
  Flag& operator=(const Flag& other) {
    raised_ = other.raised_.load();
    return *this;
  }
  void raise() { raised_.store(true, std::memory_order_relaxed); }
  /// Whether it was raised; it is not any more.
  bool take() {
    const bool was = raised_.load(std::memory_order_relaxed);
    raised_.store(false, std::memory_order_relaxed);
    return was;
  }

 private:
  std::atomic<bool> raised_ = false;
};

/// Loops shorter than this stay on the calling thread: waking another takes longer.
inline constexpr std::size_t shortest_parallel_loop = 4096;

namespace parallel {

/// Calls body(context, begin, end) for ranges that together cover 0 to count, on at most `threads` threads.
void run(int threads, std::size_t count, void (*body)(const void* context, std::size_t begin, std::size_t end),
         const void* context);

}  // namespace parallel

/// Calls body(begin, end) for ranges that together cover 0 to count, on at most `threads` >= 1 threads at once.
///
/// Which ranges there are depends on the number of threads: the body must do for each index what does not depend on
/// the others, so that the result is the same for any number. An exception of the body reaches the caller.
template <class Body>
void for_ranges(int threads, std::size_t count, const Body& body) {
  if (threads <= 1 || count < shortest_parallel_loop) {
    body(std::size_t{0}, count);
    return;
  }
  parallel::run(
      threads, count,
      [](const void* context, std::size_t begin, std::size_t end) { (*static_cast<const Body*>(context))(begin, end); },
      &body);
}

/// The same for a body that gathers something, body(begin, end, part): every range starts with a copy of `whole`, and
/// whole.merge(part) is called for one part after the other in the order of the indices.
template <class Part, class Body>
void for_ranges(int threads, std::size_t count, Part& whole, const Body& body) {
  if (threads <= 1 || count < shortest_parallel_loop) {
    body(std::size_t{0}, count, whole);
    return;
  }
  constexpr std::size_t pieces = 64;
  std::array<Part, pieces> parts;
  parts.fill(whole);
  const auto piece = [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) body(p * count / pieces, (p + 1) * count / pieces, parts[p]);
  };
  parallel::run(
      threads, pieces,
      [](const void* context, std::size_t begin, std::size_t end) {
        (*static_cast<const decltype(piece)*>(context))(begin, end);
      },
      &piece);
  for (const Part& part : parts) whole.merge(part);
}

}  // namespace moat
