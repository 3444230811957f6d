#include "output/writing_thread.hpp"

#include <system_error>
#include <utility>

namespace moat {

WritingThread::~WritingThread() {
  {
    const std::lock_guard lock{mutex_};
    ends_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void WritingThread::add(std::size_t bytes, std::function<void()> task) {
  std::unique_lock lock{mutex_};
  if (!thread_.joinable() && !failed_) {
    try {
      thread_ = std::thread{[this] { work(); }};
    } catch (const std::system_error&) {
      return task();
    }
  }
  changed_.wait(lock, [&] { return waiting_.empty() || bytes_ + bytes <= most_bytes_; });
  rethrow(lock);
  if (failed_) return;
  bytes_ += bytes;
  waiting_.push_back({bytes, std::move(task)});
  changed_.notify_all();
}

void WritingThread::wait() {
  std::unique_lock lock{mutex_};
  changed_.wait(lock, [&] { return waiting_.empty(); });
  rethrow(lock);
}

void WritingThread::rethrow(std::unique_lock<std::mutex>& lock) {
  if (!failure_) return;
  const std::exception_ptr failure = std::exchange(failure_, nullptr);
  lock.unlock();
  std::rethrow_exception(failure);
}

void WritingThread::work() {
  std::unique_lock lock{mutex_};
  for (;;) {
    changed_.wait(lock, [&] { return ends_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    lock.unlock();
    std::exception_ptr failure;
    try {
      waiting_.front().run();
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    bytes_ -= waiting_.front().bytes;
    waiting_.pop_front();
    if (failure) {
      failure_ = failure;
      failed_ = true;
      waiting_.clear();
      bytes_ = 0;
    }
    changed_.notify_all();
  }
}

}  // namespace moat
