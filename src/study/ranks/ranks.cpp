#include "study/ranks/ranks.hpp"

#include <cstdlib>

#include "base/loaded_library.hpp"

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

}  // namespace

Ranks* ranks_of_this_job() {
  // Set for every rank by OpenMPI's mpirun, and by srun with its PMIx or PMI plugin.
  static const bool has_ranks = is_set("OMPI_COMM_WORLD_RANK") || is_set("PMIX_RANK") || is_set("PMI_RANK");
  if (!has_ranks) return nullptr;
  static Ranks* const ranks = load();
  return ranks;
}

}  // namespace moat
