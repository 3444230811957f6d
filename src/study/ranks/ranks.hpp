// Processes that compute one study together, on one machine or on many.
#pragma once

#include <string>

#include "study/engine.hpp"
#include "study/result.hpp"

namespace moat {

/// The ranks of one job, as MPI calls them. Messages between two ranks keep their order. Several threads may call it at
/// once.
class Ranks {
 public:
  virtual ~Ranks() = default;
  /// From 0 to count() - 1.
  [[nodiscard]] virtual int rank() const = 0;
  /// Number of ranks, > 0.
  [[nodiscard]] virtual int count() const = 0;
  /// Sends bytes, which the rank receives once.
  virtual void send(int to, const std::string& bytes) = 0;
  /// Waits for the next message of a rank, and returns it as it was sent.
  virtual std::string receive(int from) = 0;
};

/// The ranks of the job that this process is a part of: started by mpirun, or by srun with PMI. Null for a process by
/// itself. Throws InputError where moat was built without MPI.
Ranks* ranks_of_this_job();

/// On rank 0: computes a case on another rank, and waits for its outcome. Each rank has one such function.
ComputeCase computed_on(Ranks& ranks, int rank);

/// On rank 0, after the last case: gives the outcomes of all cases to the other ranks.
void end_work(Ranks& ranks, const StudyResult& result);

/// On every other rank: computes the cases that rank 0 asks for, and returns the outcomes of all cases.
StudyResult compute_for_first_rank(Ranks& ranks, const StudyCases& cases, const ComputeCase& compute);

}  // namespace moat
