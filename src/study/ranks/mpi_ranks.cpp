// Ranks over MPI: the library libmoat_mpi.so, which study/ranks/ranks.cpp loads where a job has ranks.

#include <mpi.h>

#include <chrono>
#include <climits>
#include <mutex>
#include <string>
#include <thread>

#include "base/error.hpp"
#include "study/ranks/ranks.hpp"

namespace moat {
namespace {

constexpr int tag = 1;

int length_of(const std::string& bytes) {
  if (bytes.size() > static_cast<std::size_t>(INT_MAX))
    throw Error{"MPI: a message of more than 2 GB. Use fewer results per case, or --cases."};
  return static_cast<int>(bytes.size());
}

class MpiRanks final : public Ranks {
 public:
  MpiRanks() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
    if (provided < MPI_THREAD_SERIALIZED)
      throw Error{"MPI: this library serves one thread alone. Use one that was built with threads, or --cases."};
  }
  ~MpiRanks() override { MPI_Finalize(); }
  MpiRanks(const MpiRanks&) = delete;
  MpiRanks& operator=(const MpiRanks&) = delete;

  int rank() const override { return rank_; }
  int count() const override { return count_; }

  void send(int to, const std::string& bytes) override {
    const std::lock_guard lock{mutex_};
    MPI_Send(bytes.data(), length_of(bytes), MPI_BYTE, to, tag, MPI_COMM_WORLD);
  }

  std::string receive(int from) override {
    // MPI waits by polling at full load; the core belongs to the cases.
    for (;; std::this_thread::sleep_for(std::chrono::microseconds{100})) {
      const std::lock_guard lock{mutex_};
      int there = 0, length = 0;
      MPI_Status status;
      MPI_Iprobe(from, tag, MPI_COMM_WORLD, &there, &status);
      if (there == 0) continue;
      MPI_Get_count(&status, MPI_BYTE, &length);
      std::string bytes(static_cast<std::size_t>(length), '\0');
      MPI_Recv(bytes.data(), length, MPI_BYTE, from, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
      return bytes;
    }
  }

 private:
  std::mutex mutex_;  // MPI serves one thread at a time
  int rank_ = 0, count_ = 1;
};

}  // namespace
}  // namespace moat

extern "C" moat::Ranks* moat_ranks() {
  static moat::MpiRanks ranks;
  return &ranks;
}
