#include "base/parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace moat::parallel {

void run(int threads, std::size_t count, void (*body)(const void*, std::size_t, std::size_t), const void* context) {
  // Made once per calling thread: setting up an arena takes longer than many a loop.
  thread_local tbb::task_arena arena;
  if (!arena.is_active()) {
    arena.initialize(threads);
  } else if (arena.max_concurrency() != threads) {
    arena.terminate();
    arena.initialize(threads);
  }
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>{0, count},
        [&](const tbb::blocked_range<std::size_t>& range) { body(context, range.begin(), range.end()); },
        tbb::static_partitioner{});
  });
}

}  // namespace moat::parallel
