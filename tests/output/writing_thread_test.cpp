#include "output/writing_thread.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace moat {
namespace {

constexpr std::size_t enough = 1000;

TEST(WritingThread, RunsTasksInTheirOrder) {
  std::vector<int> done, expected(200);
  std::iota(expected.begin(), expected.end(), 0);
  WritingThread thread{enough};
  for (int i = 0; i < 200; ++i) thread.add(1, [&done, i] { done.push_back(i); });
  thread.wait();
  EXPECT_EQ(done, expected);
  thread.wait();
}

TEST(WritingThread, RunsAllTasksBeforeItsEnd) {
  int done = 0;
  {
    WritingThread thread{enough};
    for (int i = 0; i < 50; ++i) thread.add(1, [&done] { ++done; });
  }
  EXPECT_EQ(done, 50);
}

TEST(WritingThread, GoesOnWhileATaskIsRun) {
  std::promise<void> gate;
  std::atomic<bool> done = false;
  WritingThread thread{enough};
  thread.add(1, [&] {
    gate.get_future().wait();
    done = true;
  });
  thread.add(1, [] {});
  // add() came back although the first task cannot have ended.
  EXPECT_FALSE(done);
  gate.set_value();
  thread.wait();
  EXPECT_TRUE(done);
}

TEST(WritingThread, HoldsNoMoreThanItsLimitButAlwaysOneTask) {
  std::atomic<int> waiting = 0, most = 0;
  WritingThread thread{enough};
  for (int i = 0; i < 100; ++i) {
    thread.add(enough / 2, [&] { --waiting; });
    // The one being run was taken off already, or will be.
    most = std::max<int>(most, ++waiting);
  }
  thread.wait();
  EXPECT_LE(most, 3);
  bool large = false;
  thread.add(10 * enough, [&] { large = true; });
  thread.wait();
  EXPECT_TRUE(large);
}

TEST(WritingThread, ThrowsTheErrorOfATaskOnceAndRunsNoOther) {
  bool later = false;
  WritingThread thread{enough};
  thread.add(1, [] { throw std::runtime_error{"disk full"}; });
  EXPECT_THROW(thread.wait(), std::runtime_error);
  thread.add(1, [&] { later = true; });
  thread.wait();
  EXPECT_FALSE(later);
}

}  // namespace
}  // namespace moat
