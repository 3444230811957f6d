// Ranks over MPI: the library libmoat_mpi.so, which study/ranks/ranks.cpp loads where a job has ranks.

#include <mpi.h>

#include <climits>
#include <string>

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
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
  }
  ~MpiRanks() override { MPI_Finalize(); }
  MpiRanks(const MpiRanks&) = delete;
  MpiRanks& operator=(const MpiRanks&) = delete;

  int rank() const override { return rank_; }
  int count() const override { return count_; }

  void send(int to, const std::string& bytes) override {
    MPI_Send(bytes.data(), length_of(bytes), MPI_BYTE, to, tag, MPI_COMM_WORLD);
  }

  std::optional<Message> receive() override {
    int there = 0, length = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, tag, MPI_COMM_WORLD, &there, &status);
    if (there == 0) return std::nullopt;
    MPI_Get_count(&status, MPI_BYTE, &length);
    Message message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(length), '\0')};
    MPI_Recv(message.bytes.data(), length, MPI_BYTE, message.from, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return message;
  }

  void broadcast(std::string& bytes) override {
    int length = length_of(bytes);
    MPI_Bcast(&length, 1, MPI_INT, 0, MPI_COMM_WORLD);
    bytes.resize(static_cast<std::size_t>(length));
    MPI_Bcast(bytes.data(), length, MPI_BYTE, 0, MPI_COMM_WORLD);
  }

 private:
  int rank_ = 0, count_ = 1;
};

}  // namespace
}  // namespace moat

extern "C" moat::Ranks* moat_ranks() {
  static moat::MpiRanks ranks;
  return &ranks;
}
