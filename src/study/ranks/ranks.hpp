// Processes that compute one study together, on one machine or on many.
#pragma once

#include <optional>
#include <string>

namespace moat {

/// The ranks of one job, as MPI calls them. Messages between two ranks keep their order. Called by one thread.
class Ranks {
 public:
  /// Bytes from a rank.
  struct Message {
    int from;           ///< its rank
    std::string bytes;  ///< as sent
  };

  virtual ~Ranks() = default;
  /// From 0 to count() - 1.
  [[nodiscard]] virtual int rank() const = 0;
  /// Number of ranks, > 0.
  [[nodiscard]] virtual int count() const = 0;
  /// Does not wait for the receiver.
  virtual void send(int to, const std::string& bytes) = 0;
  /// The next message from any rank; nothing if none has come.
  virtual std::optional<Message> receive() = 0;
  /// Gives the bytes of rank 0 to all ranks; every rank calls it.
  virtual void broadcast(std::string& bytes) = 0;
};

/// The ranks of the job that this process is a part of: started by mpirun, or by srun with PMI. Null for a process by
/// itself. Throws InputError where moat was built without MPI.
Ranks* ranks_of_this_job();

}  // namespace moat
