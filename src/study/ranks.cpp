#include "study/ranks.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>

#include "base/error.hpp"

namespace moat {
namespace {

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

/// The library with MPI lies beside that of moat. It is loaded only where a job has ranks: no other program pays for
/// it.
Ranks* load() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&ranks_of_this_job), &info) == 0 || info.dli_fname == nullptr)
    throw InputError{"MPI: the library of moat cannot be located."};
  const auto file = std::filesystem::path{info.dli_fname}.parent_path() / "libmoat_mpi.so";
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (library == nullptr)
    throw InputError{"MPI: this job has ranks, and moat was built without MPI: " + std::string{dlerror()} +
                     ". Install libopenmpi-dev and openmpi-bin, and configure with -DMOAT_MPI=ON; or start the program "
                     "without mpirun."};
  using Make = Ranks* (*)();
  const auto make = reinterpret_cast<Make>(dlsym(library, "moat_ranks"));
  if (make == nullptr) throw InputError{"MPI: " + file.string() + " is of another version of moat. Build moat again."};
  return make();
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
