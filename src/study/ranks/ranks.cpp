#include "study/ranks/ranks.hpp"

#include <cstdlib>

#include "base/loaded_library.hpp"
#include "study/outcome_bytes.hpp"

namespace moat {
namespace {

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

Ranks* load() {
  using Make = Ranks* (*)();
  return reinterpret_cast<Make>(loaded_function("libmoat_mpi.so", "moat_ranks",
                                                "MPI: this job has ranks, and moat was built without MPI",
                                                "Install libopenmpi-dev and openmpi-bin, and configure with "
                                                "-DMOAT_MPI=ON; or start the program without mpirun."))();
}

// Rank 0 sends the number of a case as text; behind this word the outcomes of all cases follow, one by one.
const std::string end = "end";

}  // namespace

Ranks* ranks_of_this_job() {
  // Set for every rank by OpenMPI's mpirun, and by srun with its PMIx or PMI plugin.
  static const bool has_ranks = is_set("OMPI_COMM_WORLD_RANK") || is_set("PMIX_RANK") || is_set("PMI_RANK");
  if (!has_ranks) return nullptr;
  static Ranks* const ranks = load();
  return ranks;
}

ComputeCase computed_on(Ranks& ranks, int rank) {
  return [&ranks, rank](const StudyCase& each) {
    ranks.send(rank, std::to_string(each.number()));
    return from_bytes(ranks.receive(rank));
  };
}

void end_work(Ranks& ranks, const StudyResult& result) {
  const auto send_to_all = [&](const std::string& message) {
    for (int rank = 1; rank < ranks.count(); ++rank) ranks.send(rank, message);
  };
  send_to_all(end);
  for (std::size_t number = 0; number < result.cases().count(); ++number) send_to_all(to_bytes(result.outcome(number)));
}

StudyResult compute_for_first_rank(Ranks& ranks, const StudyCases& cases, const ComputeCase& compute) {
  std::string message;
  while ((message = ranks.receive(0)) != end)
    ranks.send(0, to_bytes(outcome_of(StudyCase{cases, std::stoul(message)}, compute)));
  StudyResult result{cases};
  for (std::size_t number = 0; number < cases.count(); ++number) result.set(number, from_bytes(ranks.receive(0)));
  return result;
}

}  // namespace moat
