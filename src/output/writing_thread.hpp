// Files written while the caller goes on.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace moat {

/// Runs tasks in the order in which they were added, in a thread of its own, which starts with the first. Where the
/// system gives no thread, add() runs the task itself. After a task that throws no other is run.
class WritingThread {
 public:
  /// most_bytes: how much memory tasks may hold that wait.
  explicit WritingThread(std::size_t most_bytes) : most_bytes_{most_bytes} {}
  /// As wait(), but an exception is lost.
  ~WritingThread();
  WritingThread(const WritingThread&) = delete;
  WritingThread& operator=(const WritingThread&) = delete;

  /// bytes: the memory that the task holds. Returns at once where that leaves no more than `most_bytes` waiting, else
  /// when enough tasks are done. Throws the exception of an earlier task.
  void add(std::size_t bytes, std::function<void()> task);
  /// Until all tasks are done. Throws the exception of a task.
  void wait();

 private:
  struct Task {
    std::size_t bytes;
    std::function<void()> run;
  };

  void work();
  void rethrow(std::unique_lock<std::mutex>& lock);

  std::size_t most_bytes_;
  std::mutex mutex_;                 // of all members below
  std::condition_variable changed_;  // any of them
  std::deque<Task> waiting_;         // the first one is being run
  std::size_t bytes_ = 0;            // of all in waiting_
  std::exception_ptr failure_;       // not thrown yet
  bool failed_ = false, ends_ = false;
  std::thread thread_;
};

}  // namespace moat
